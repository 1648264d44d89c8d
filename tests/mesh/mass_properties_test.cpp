#include "craze/mesh/mass_properties.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "craze/shapes.h"

namespace craze {
namespace {

/// A box of these sides with a corner at the origin.
SurfaceMesh box(const Vec3& sides) {
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back(i & 1 ? sides.x() : 0, i & 2 ? sides.y() : 0,
                                i & 4 ? sides.z() : 0);
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TEST(MassProperties, OfABoxAreThoseOfItsFormula) {
  const Vec3 s(2, 3, 5);
  const SurfaceMesh mesh = box(s);
  const MassProperties mass = mass_properties(mesh.positions, mesh.triangles);
  EXPECT_NEAR(mass.volume, 30, 1e-12);
  EXPECT_TRUE(mass.centre.isApprox(s / 2, 1e-14));
  const Vec3 inertia = 30.0 / 12 * Vec3(9 + 25, 4 + 25, 4 + 9);
  EXPECT_TRUE(mass.inertia.isApprox(Mat3(inertia.asDiagonal()), 1e-13));
}

TEST(MassProperties, TurnAndMoveWithTheSolid) {
  SurfaceMesh mesh = box({2, 3, 5});
  const MassProperties still = mass_properties(mesh.positions, mesh.triangles);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, -2, 3).normalized()).toRotationMatrix();
  const Vec3 way(300, -20, 10);
  for (Vec3& p : mesh.positions) p = turn * p + way;
  const MassProperties moved = mass_properties(mesh.positions, mesh.triangles);
  EXPECT_NEAR(moved.volume, still.volume, 1e-9);
  EXPECT_TRUE(moved.centre.isApprox(turn * still.centre + way, 1e-12));
  EXPECT_TRUE(moved.inertia.isApprox(turn * still.inertia * turn.transpose(), 1e-9));
}

TEST(MassProperties, HaveAnInertiaThatIsSymmetricToTheLastBit) {
  for (int i = 1; i < 20; ++i) {
    SurfaceMesh mesh = box({0.1 * i, 0.7, 1.3});
    mesh.positions[i % 8] += Vec3(0.31, -0.17 * i, 0.23);  // off the mean
    const Mat3 inertia = mass_properties(mesh.positions, mesh.triangles).inertia;
    EXPECT_EQ(inertia, Mat3(inertia.transpose())) << i;
  }
}

TEST(MassProperties, ChangeTheirSignWhereTheSurfaceIsTurnedInsideOut) {
  SurfaceMesh mesh = make_shape("sphere?n=8");
  const MassProperties mass = mass_properties(mesh.positions, mesh.triangles);
  EXPECT_GT(mass.volume, 0);
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  const MassProperties turned = mass_properties(mesh.positions, mesh.triangles);
  EXPECT_DOUBLE_EQ(turned.volume, -mass.volume);
  EXPECT_TRUE(turned.inertia.isApprox(-mass.inertia, 1e-12));
}

TEST(MassProperties, OfNothingAreZero) {
  EXPECT_EQ(mass_properties({}, {}).volume, 0);
  EXPECT_EQ(mass_properties({Vec3(1, 2, 3)}, {}).centre, Vec3(1, 2, 3));
}

}  // namespace
}  // namespace craze
