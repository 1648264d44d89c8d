#include "craze/mesh/smooth_normals.h"

#include <gtest/gtest.h>

#include "products/distance/surfaces.h"

namespace craze {
namespace {

SurfaceMesh cube() {
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TEST(SmoothNormals, StayFlatAcrossACreaseAndRoundBelowIt) {
  const SurfaceMesh mesh = cube();
  const std::vector<Vec3> sharp = smooth_normals(mesh, 50), round = smooth_normals(mesh, 100);
  for (std::size_t c = 0; c < sharp.size(); ++c) {
    EXPECT_NEAR(sharp[c].cwiseAbs().maxCoeff(), 1, 1e-6);
    // Angle weights make a cube's corner symmetric, however its faces are divided.
    EXPECT_NEAR(round[c].cwiseAbs().minCoeff(), std::sqrt(1 / 3.0), 1e-6);
  }
}

TEST(SmoothNormals, PointOutwardsOnATorus) {
  const TriangleMesh torus = test::torus(60);
  SurfaceMesh mesh;
  mesh.positions = torus.positions();
  mesh.triangles = torus.triangles();
  const std::vector<Vec3> normals = smooth_normals(mesh, 50);
  for (std::size_t c = 0; c < normals.size(); ++c) {
    const Vec3& p = mesh.positions[mesh.triangles[c / 3][c % 3]];
    const Vec3 centre = Vec3(p.x(), 0, p.z()).normalized();
    EXPECT_GT(normals[c].dot((p - centre).normalized()), 0.999);
  }
}

}  // namespace
}  // namespace craze
