#include "craze/io/gltf/line_lifts.h"

#include <Eigen/Geometry>

namespace craze {

namespace {

/// Of the diagonal: what a depth buffer of 24 bits tells apart from anywhere near the object, and
/// the eye does not.
constexpr double lift = 2e-4;

}  // namespace

std::vector<Vec3> line_lifts(const SurfaceMesh& mesh) {
  std::vector<Vec3> lifts(mesh.positions.size(), Vec3::Zero());
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  for (const Triangle& t : mesh.triangles) {
    const Vec3& p = mesh.positions[t[0]];
    const Vec3 n = (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p);
    for (const std::int32_t v : t) lifts[v] += n;
  }
  for (Vec3& n : lifts) n = n.stableNormalized() * (lift * box.diagonal().norm());
  return lifts;
}

}  // namespace craze
