#include "part_boxes.h"

#include "craze/mesh/components.h"

namespace craze::app {

std::vector<PartBox> part_boxes(const TriangleMesh& mesh) {
  const Components components = find_components(mesh);
  std::vector<PartBox> parts(static_cast<std::size_t>(components.count));
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    PartBox& part = parts[components.face[f]];
    ++part.triangles;
    for (const std::int32_t v : mesh.triangle(f)) part.box.extend(mesh.position(v));
  }
  return parts;
}

}  // namespace craze::app
