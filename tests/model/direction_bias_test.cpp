#include "craze/model/failure/direction_bias.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "craze/base/random.h"
#include "model/analytic_surfaces.h"

namespace craze {
namespace {

struct Largest {
  double value;
  Vec3 vector;
};

Largest largest(const Sym3& s) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(s.matrix());
  return {solver.eigenvalues()[2], solver.eigenvectors().col(2)};
}

Sym3 random_tangent_tensor(Random& random) {  // in the plane z = 0
  const Vec3 a(random.normal(), random.normal(), 0), b(random.normal(), random.normal(), 0);
  Sym3 s;
  add_outer(s, 1, a);
  add_outer(s, 1, b);
  return s;
}

TEST(DirectionBias, ZeroBiasOrZeroConfidenceChangesNothing) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Sym3 s = random_tangent_tensor(random);
    EXPECT_TRUE(bias_direction(s, {Vec3::UnitY(), 1}, 0).matrix() == s.matrix());
    EXPECT_TRUE(bias_direction(s, {Vec3::UnitY(), 0}, 1).matrix() == s.matrix());
  }
}

TEST(DirectionBias, UnderEqualTensionTheCrackRunsAlongTheDirectionAtTheSameLoad) {
  const Vec3 along = Vec3(1, 2, 0).normalized();
  const Sym3 s{3, 3, 0, 0, 0, 0};
  const double biases[] = {0.01, 0.5, 1};
  for (const double bias : biases) {
    const Largest l = largest(bias_direction(s, {along, 0.8}, bias));
    EXPECT_NEAR(l.value, 3, 1e-12);
    EXPECT_NEAR(l.vector.dot(along), 0, 1e-9);
  }
}

TEST(DirectionBias, MoreBiasTurnsTheCrackFurtherAndNeverStrengthensThePull) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Sym3 s = random_tangent_tensor(random);
    double tilt = 10, load = 1e300;
    for (double bias = 0; bias <= 1; bias += 0.125) {
      const Largest l = largest(bias_direction(s, {Vec3::UnitX(), 1}, bias));
      const double now = std::abs(l.vector.x());  // of the crack's normal towards `along`
      EXPECT_LE(now, tilt + 1e-9);
      EXPECT_LE(l.value, load + 1e-9);
      tilt = now;
      load = l.value;
    }
    EXPECT_NEAR(tilt, 0, 1e-9);
  }
}

TEST(DirectionBias, IsSScaledFromBothSides) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    Sym3 s;
    for (int k = 0; k < 3; ++k) {
      add_outer(s, random.normal(), Vec3(random.normal(), random.normal(), random.normal()));
    }
    const Vec3 t = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    const Mat3 scale = Mat3::Identity() - (1 - std::sqrt(1 - 0.6 * 0.7)) * t * t.transpose();
    const Mat3 expected = scale * s.matrix() * scale;
    EXPECT_TRUE(bias_direction(s, {t, 0.7}, 0.6).matrix().isApprox(expected, 1e-12));
  }
}

TEST(DirectionBias, CracksRunAlongATubeAndNowhereOnASphere) {
  const TriangleMesh tube = test::cylinder(72, 1, 0);
  for (const PreferredDirection& p : preferred_directions(vertex_curvature(tube, 0, Context{}))) {
    EXPECT_GT(std::abs(p.along.z()), 0.999);
    EXPECT_NEAR(p.confidence, 16.0 / 17, 0.02);
  }
  const TriangleMesh ball = test::sphere(24, 1, 0.1);
  for (const PreferredDirection& p : preferred_directions(vertex_curvature(ball, 0, Context{}))) {
    EXPECT_LT(p.confidence, 0.02);
  }
  const TriangleMesh flat = test::plate(8, 1, 0.2);
  for (const PreferredDirection& p : preferred_directions(vertex_curvature(flat, 0, Context{}))) {
    EXPECT_EQ(p.confidence, 0);
  }
}

}  // namespace
}  // namespace craze
