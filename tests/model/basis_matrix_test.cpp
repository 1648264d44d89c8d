#include "craze/model/basis_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "model/states.h"

namespace craze {
namespace {

using test::mesh_of;
using test::no_cap;

Mat2 random_matrix(Random& random) {
  Mat2 m;
  m << random.normal(), random.normal(), random.normal(), random.normal();
  return m;
}

TEST(BasisMatrix, TurnsPositionsIntoBarycentricCoordinates) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p0 = test::random_unit(random), p1 = test::random_unit(random),
               p2 = test::random_unit(random);
    const Mat32 frame = tangent_frame(p0, p1, p2);
    const Mat2 beta = basis_matrix(p0, p1, p2);
    const double a = random.uniform(), b = random.uniform();
    const Vec3 inside = p0 + a * (p1 - p0) + b * (p2 - p0);
    const Vec2 in_frame = frame.transpose() * (inside - p0);
    const Vec2 coordinates = beta * in_frame;
    EXPECT_NEAR(coordinates.x(), a, 1e-9);
    EXPECT_NEAR(coordinates.y(), b, 1e-9);
  }
}

/// The gradients of all three barycentric coordinates.
Mat32 gradients(const Mat2& beta) {
  Mat32 g;
  g << -beta.row(0) - beta.row(1), beta;
  return g;
}

TEST(BasisMatrix, SingularValuesAreThoseOfAllThreeGradients) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Mat2 beta = random_matrix(random);
    const Vec2 expected = Eigen::JacobiSVD<Mat32>(gradients(beta)).singularValues();
    EXPECT_NEAR(singular_values(beta).largest, expected[0], 1e-12);
    EXPECT_NEAR(singular_values(beta).smallest, expected[1], 1e-12);
  }
  const SingularValues degenerate = singular_values(Mat2::Zero());
  EXPECT_EQ(degenerate.largest, 0);
  EXPECT_EQ(degenerate.smallest, 0);
}

TEST(BasisMatrix, SingularValuesDoNotDependOnWhichCornerComesFirst) {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p0 = test::random_unit(random), p1 = test::random_unit(random),
               p2 = test::random_unit(random);
    const SingularValues a = singular_values(basis_matrix(p0, p1, p2));
    const SingularValues b = singular_values(basis_matrix(p1, p2, p0));
    EXPECT_NEAR(a.largest / b.largest, 1, 1e-9);
    EXPECT_NEAR(a.smallest / b.smallest, 1, 1e-9);
  }
}

TEST(BasisMatrix, TheCapLimitsSingularValuesAndKeepsSingularVectors) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Mat2 beta = random_matrix(random);
    const double cap = random.uniform(0.1, 2);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(gradients(beta),
                                                Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Vec2 limited = svd.singularValues().cwiseMin(cap);
    const Mat32 expected = svd.matrixU() * limited.asDiagonal() * svd.matrixV().transpose();
    EXPECT_LT((gradients(cap_singular_values(beta, cap)) - expected).norm(), 1e-12);
  }
}

TEST(BasisMatrix, ATriangleBelowTheCapIsLeftAsItIs) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Mat2 m = random_matrix(random);
    EXPECT_EQ(cap_singular_values(m, no_cap), m);
    EXPECT_EQ(cap_singular_values(m, singular_values(m).largest * 1.0001), m);
  }
}

TEST(BasisMatrix, TheThresholdComesFromTheInputAndScalesAsOneOverLength) {
  const double small = singular_value_cap(mesh_of("plate?n=20&jitter=0.2"));
  const double large = singular_value_cap(mesh_of("plate?n=20&jitter=0.2&size=10"));
  EXPECT_NEAR(large / small, 0.1, 1e-9);
}

TEST(BasisMatrix, TheThresholdIgnoresAFewSliversOfTheInput) {
  SurfaceMesh s = make_shape("plate?n=20");
  const double before = singular_value_cap(TriangleMesh(s.positions, s.triangles));
  // Two slivers in 800 triangles: one inner vertex pushed almost onto the next.
  const std::int32_t a = s.triangles[400][0], b = s.triangles[400][1];
  s.positions[a] = 0.9999 * s.positions[b] + 0.0001 * s.positions[a];
  const double after = singular_value_cap(TriangleMesh(s.positions, s.triangles));
  EXPECT_NEAR(after / before, 1, 0.05);
}

TEST(BasisMatrix, MostTrianglesOfAnEvenMeshAreNotCapped) {
  const TriangleMesh mesh = mesh_of("sphere?n=8");
  const double cap = singular_value_cap(mesh);
  for (const Triangle& t : mesh.triangles()) {
    const Mat2 beta = basis_matrix(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    EXPECT_LT(singular_values(beta).largest, cap);
  }
}

}  // namespace
}  // namespace craze
