#include "craze/products/opening/turned_normals.h"

#include <gtest/gtest.h>

#include <cmath>

namespace craze {
namespace {

/// n × n squares of side 1 / n, smooth but for a hard edge along x = 0.5 where `folded`.
SurfaceMesh sheet(int n, bool folded) {
  SurfaceMesh mesh;
  const auto height = [&](double x) { return folded ? std::abs(x - 0.5) : 0.0; };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n;
      mesh.positions.emplace_back(x, static_cast<double>(j) / n, height(x));
    }
  }
  const double slope = folded ? std::sqrt(0.5) : 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const std::int32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
      const Vec3 normal(i < n / 2 ? slope : -slope, 0, std::sqrt(1 - slope * slope));
      mesh.corner_normals.insert(mesh.corner_normals.end(), 6, normal);
    }
  }
  return mesh;
}

TEST(TurnedNormals, StayToTheBitWhereNothingTurns) {
  const SurfaceMesh flat = sheet(6, true);
  EXPECT_EQ(turned_normals(flat, flat.positions), flat.corner_normals);
  std::vector<Vec3> moved = flat.positions;
  for (Vec3& p : moved) p += Vec3(4, 2, 1);
  const std::vector<Vec3> normals = turned_normals(flat, moved);
  for (std::size_t c = 0; c < normals.size(); ++c) {
    EXPECT_LT((normals[c] - flat.corner_normals[c]).norm(), 1e-12);
  }
}

TEST(TurnedNormals, OfASheetBentToACylinderAreThoseOfTheCylinder) {
  const SurfaceMesh flat = sheet(24, false);
  std::vector<Vec3> bent;
  for (const Vec3& p : flat.positions)
    bent.emplace_back(std::sin(p.x()), p.y(), std::cos(p.x()) - 1);
  const std::vector<Vec3> normals = turned_normals(flat, bent);
  for (std::size_t c = 0; c < normals.size(); ++c) {
    const double x = flat.positions[flat.triangles[c / 3][c % 3]].x();
    if (x < 0.01 || x > 0.99) continue;  // at a border there is one side alone
    EXPECT_LT((normals[c] - Vec3(std::sin(x), 0, std::cos(x))).norm(), 1e-3);
  }
}

TEST(TurnedNormals, HardEdgesStayHardAndNormalsOfTheUsersOwnTurnAlong) {
  SurfaceMesh flat = sheet(6, true);
  // As a scene of weighted normals has them: not those of the faces.
  const Vec3 own = Vec3(0.2, 0.1, 1).normalized();
  for (std::size_t c = 0; c < 6; ++c) flat.corner_normals[c] = own;
  std::vector<Vec3> turned;
  for (const Vec3& p : flat.positions) turned.emplace_back(p.z(), p.y(), -p.x());
  const std::vector<Vec3> normals = turned_normals(flat, turned);
  for (std::size_t c = 0; c < normals.size(); ++c) {
    const Vec3& n = flat.corner_normals[c];
    EXPECT_LT((normals[c] - Vec3(n.z(), n.y(), -n.x())).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace craze
