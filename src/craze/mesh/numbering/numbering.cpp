#include "craze/mesh/numbering/numbering.h"

namespace craze {

std::vector<std::int32_t> inverse(const std::vector<std::int32_t>& permutation) {
  std::vector<std::int32_t> result(permutation.size());
  for (std::size_t i = 0; i < permutation.size(); ++i) {
    result[permutation[i]] = static_cast<std::int32_t>(i);
  }
  return result;
}

Numbering inverse(const Numbering& numbering) {
  return {inverse(numbering.vertices), inverse(numbering.faces)};
}

void renumber(SurfaceMesh& surface, const Numbering& numbering) {
  const std::vector<std::int32_t> now = inverse(numbering.vertices);
  for (Triangle& t : surface.triangles) {
    for (std::int32_t& v : t) v = now[v];
  }
  reorder(surface.positions, numbering.vertices);
  reorder(surface.vertex_colors, numbering.vertices);
  reorder(surface.triangles, numbering.faces);
  reorder(surface.corner_uvs, numbering.faces, 3);
  reorder(surface.corner_normals, numbering.faces, 3);
  reorder(surface.face_materials, numbering.faces);
  reorder(surface.face_objects, numbering.faces);
  reorder(surface.source_faces, numbering.faces);
  for (Attribute& a : surface.vertex_attributes) a = pick(a, numbering.vertices);
  for (Attribute& a : surface.face_attributes) a = pick(a, numbering.faces);
}

}  // namespace craze
