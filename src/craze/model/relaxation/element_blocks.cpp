#include "craze/model/relaxation/element_blocks.h"

#include <algorithm>

namespace craze {

ElementBlocks::ElementBlocks(const TriangleMesh& mesh) {
  update(mesh, {});
}

void ElementBlocks::update(const TriangleMesh& mesh,
                           const std::vector<std::int32_t>& changed_faces) {
  node_blocks_ = (mesh.vertex_count() + nodes_per_block - 1) / nodes_per_block;
  touched_.resize((mesh.face_count() + elements_per_block - 1) / elements_per_block);
  for (; faces_ < mesh.face_count(); ++faces_) add_face(mesh, faces_);
  for (const std::int32_t f : changed_faces) add_face(mesh, f);
}

void ElementBlocks::add_face(const TriangleMesh& mesh, std::int32_t f) {
  std::vector<std::int32_t>& nodes = touched_[f / elements_per_block];
  for (const std::int32_t v : mesh.triangle(f)) {
    const std::int32_t block = v / nodes_per_block;
    const auto place = std::lower_bound(nodes.begin(), nodes.end(), block);
    if (place == nodes.end() || *place != block) nodes.insert(place, block);
  }
}

}  // namespace craze
