#include "craze/mesh/components.h"

namespace craze {

Components find_components(const TriangleMesh& mesh) {
  Components parts;
  parts.face.assign(mesh.face_count(), -1);
  std::vector<std::int32_t> pending;
  for (std::int32_t seed = 0; seed < mesh.face_count(); ++seed) {
    if (parts.face[seed] >= 0) continue;
    parts.face[seed] = parts.count;
    pending.push_back(seed);
    while (!pending.empty()) {
      const std::int32_t f = pending.back();
      pending.pop_back();
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        if (mesh.is_open(h)) continue;
        const std::int32_t neighbour = TriangleMesh::face_of(mesh.opposite(h));
        if (parts.face[neighbour] >= 0) continue;
        parts.face[neighbour] = parts.count;
        pending.push_back(neighbour);
      }
    }
    ++parts.count;
  }
  return parts;
}

}  // namespace craze
