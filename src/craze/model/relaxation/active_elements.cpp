#include "craze/model/relaxation/active_elements.h"

#include <algorithm>

namespace craze {

void ActiveElements::find(const ElementBlocks& blocks, const std::vector<char>& moving) {
  if (moving == moving_) return;
  moving_ = moving;
  blocks_.clear();
  for (std::int32_t block = 0; block < blocks.element_blocks(); ++block) {
    const std::vector<std::int32_t>& nodes = blocks.nodes_of(block);
    if (std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return moving[n] != 0; })) {
      blocks_.push_back(block);
    }
  }
  touched_.assign(moving.size(), 0);
  for (int lane = 0; lane < lanes; ++lane) {
    for_lane(lane, [&](std::int32_t block) {
      for (const std::int32_t n : blocks.nodes_of(block)) {
        touched_[n] = static_cast<unsigned char>(touched_[n] | 1U << lane);
      }
    });
  }
}

}  // namespace craze
