#include "craze/products/opening/vertex_normals.h"

#include "craze/base/elementary.h"

namespace craze {

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh, const CrackSites& sites) {
  std::vector<Vec3> sum(mesh.vertex_count(), Vec3::Zero());
  const auto owner = [&](std::int32_t v) {
    return sites.site_of[v] < 0 ? v : sites.vertex[sites.site_of[v]];
  };
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const std::int32_t v = mesh.from(h);
    const Vec3 a = mesh.position(mesh.to(h)) - mesh.position(v);
    const Vec3 b = mesh.position(mesh.from(TriangleMesh::prev(h))) - mesh.position(v);
    const Vec3 normal = a.cross(b);
    const double length = normal.norm();
    if (length > 0) sum[owner(v)] += elementary::atan2(length, a.dot(b)) / length * normal;
  }
  std::vector<Vec3> normals(sum.size());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    normals[v] = sum[owner(v)].stableNormalized();
  }
  return normals;
}

}  // namespace craze
