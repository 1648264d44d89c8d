#include "craze/products/opening/turned_normals.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "craze/base/elementary.h"

namespace craze {

namespace {

/// Cosine of the angle within which interpolated normals are one: about 0.1 degrees.
constexpr double same_normal = 1 - 1e-6;

/// The face's normal times its angle at a corner; zero where it has no area.
Vec3 weighted_normal(const std::vector<Vec3>& positions, const Triangle& t, std::size_t corner) {
  const Vec3& p = positions[t[corner]];
  const Vec3 a = positions[t[(corner + 1) % 3]] - p, b = positions[t[(corner + 2) % 3]] - p;
  const Vec3 normal = a.cross(b);
  const double length = normal.norm();
  if (!(length > 0)) return Vec3::Zero();
  return elementary::atan2(length, a.dot(b)) / length * normal;
}

/// The corners at each vertex.
std::vector<std::vector<std::size_t>> corners_by_vertex(const SurfaceMesh& mesh) {
  std::vector<std::vector<std::size_t>> corners(mesh.positions.size());
  for (std::size_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
    corners[mesh.triangles[c / 3][c % 3]].push_back(c);
  }
  return corners;
}

}  // namespace

std::vector<Vec3> turned_normals(const SurfaceMesh& flat, const std::vector<Vec3>& bent) {
  std::vector<Vec3> normals = flat.corner_normals;
  for (std::vector<std::size_t>& corners : corners_by_vertex(flat)) {
    for (auto piece = corners.begin(); piece != corners.end();) {
      const Vec3& normal = flat.corner_normals[*piece];
      const auto end = std::stable_partition(piece + 1, corners.end(), [&](std::size_t c) {
        return normal.dot(flat.corner_normals[c]) >= same_normal;
      });
      Vec3 before = Vec3::Zero(), after = Vec3::Zero();
      for (auto c = piece; c != end; ++c) {
        const Triangle& t = flat.triangles[*c / 3];
        before += weighted_normal(flat.positions, t, *c % 3);
        after += weighted_normal(bent, t, *c % 3);
      }
      const bool turns = before != after && !before.isZero(0) && !after.isZero(0);
      const auto turn = Eigen::Quaterniond::FromTwoVectors(before, after);
      for (; piece != end; ++piece) {
        if (turns) normals[*piece] = (turn * flat.corner_normals[*piece]).normalized();
      }
    }
  }
  return normals;
}

}  // namespace craze
