// Consecutive elements and nodes in blocks, so that whatever is at rest is skipped as a whole.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// Which node blocks each element block touches, kept up to date as the mesh grows.
class ElementBlocks {
 public:
  static constexpr std::int32_t elements_per_block = 256;
  static constexpr std::int32_t nodes_per_block = 128;
  static constexpr std::size_t blocks_per_chunk = 16;  ///< what a thread takes at once

  explicit ElementBlocks(const TriangleMesh& mesh);

  /// Takes in faces and vertices appended since, and the faces listed, whose corners changed.
  void update(const TriangleMesh& mesh, const std::vector<std::int32_t>& changed_faces);

  std::int32_t element_blocks() const { return static_cast<std::int32_t>(touched_.size()); }
  std::int32_t node_blocks() const { return node_blocks_; }
  /// Node blocks that the elements of a block have corners in, ascending.
  const std::vector<std::int32_t>& nodes_of(std::int32_t element_block) const {
    return touched_[element_block];
  }

 private:
  void add_face(const TriangleMesh& mesh, std::int32_t f);

  std::int32_t faces_ = 0;
  std::int32_t node_blocks_ = 0;
  std::vector<std::vector<std::int32_t>> touched_;
};

}  // namespace craze
