#include "craze/mesh/feature_lines.h"

#include <cmath>
#include <numbers>

namespace craze {

namespace {

Vec3 unit_normal(const TriangleMesh& mesh, std::int32_t f) {
  const Triangle& t = mesh.triangle(f);
  const Vec3& a = mesh.position(t[0]);
  return (mesh.position(t[1]) - a).cross(mesh.position(t[2]) - a).normalized();
}

bool is_seam(const SurfaceMesh& s, std::int32_t h, std::int32_t o) {
  if (!s.face_materials.empty() && s.face_materials[h / 3] != s.face_materials[o / 3]) return true;
  if (s.corner_uvs.empty()) return false;
  // Readers may round the two sides differently; a millionth of the texture shows nowhere.
  const auto differ = [&](std::int32_t c, std::int32_t d) {
    return !((s.corner_uvs[c] - s.corner_uvs[d]).norm() < 1e-6);
  };
  return differ(h, TriangleMesh::next(o)) || differ(TriangleMesh::next(h), o);
}

}  // namespace

std::vector<char> feature_lines(const SurfaceMesh& surface, const TriangleMesh& mesh,
                                double angle) {
  const double cosine = std::cos(angle * std::numbers::pi / 180);
  std::vector<Vec3> normals;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) normals.push_back(unit_normal(mesh, f));
  std::vector<char> marks(3 * mesh.face_count(), no_feature);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const std::int32_t o = mesh.opposite(h);
    if (o < 0) {
      marks[h] = crease;
    } else if (is_seam(surface, h, o)) {
      marks[h] = seam;
    } else if (normals[h / 3].dot(normals[o / 3]) < cosine) {
      marks[h] = crease;
    }
  }
  return marks;
}

}  // namespace craze
