// Which elements a step has to update: those with a moving corner, and what they touch.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/model/relaxation/element_blocks.h"

namespace craze {

/// The element blocks with a moving node, dealt out to a fixed number of lanes. Force changes are
/// summed per lane, each by one thread in order, and the lanes in order: the same sums on any
/// number of threads.
class ActiveElements {
 public:
  static constexpr int lanes = 4;

  /// `moving`: per node block. Costs nothing where it is the same as last time.
  void find(const ElementBlocks& blocks, const std::vector<char>& moving);
  /// Forgets last time: the blocks have changed.
  void reset() { moving_.clear(); }

  std::int64_t count() const { return static_cast<std::int64_t>(blocks_.size()); }
  /// Calls body(element block) for the blocks of a lane.
  template <class Body>
  void for_lane(int lane, const Body& body) const {
    for (std::size_t i = begin(lane); i < begin(lane + 1); ++i) body(blocks_[i]);
  }
  /// Per node block: a bit for each lane whose elements touch it.
  unsigned touched(std::size_t node_block) const { return touched_[node_block]; }

 private:
  std::size_t begin(int lane) const { return blocks_.size() * lane / lanes; }

  std::vector<char> moving_;
  std::vector<std::int32_t> blocks_;
  std::vector<unsigned char> touched_;
};

}  // namespace craze
