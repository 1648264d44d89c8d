#include "craze/base/symmetric_eigen.h"

#include <gtest/gtest.h>

#include <cmath>

#include "craze/base/random.h"

namespace craze {
namespace {

Sym3 tensor_of(const Vec3& values, const Mat3& axes) {
  Sym3 sum;
  for (int i = 0; i < 3; ++i) add_outer(sum, values[i], axes.col(i));
  return sum;
}

Mat3 random_axes(Random& random) {
  const Eigen::Quaterniond q(random.normal(), random.normal(), random.normal(), random.normal());
  return q.normalized().toRotationMatrix();
}

void expect_largest(const Vec3& values, const Mat3& axes) {
  const Sym3 tensor = tensor_of(values, axes);
  const double size = values.cwiseAbs().maxCoeff();
  const Eigenpair pair = largest_eigenpair(tensor);
  EXPECT_NEAR(pair.value, values.maxCoeff(), 4e-15 * size) << values.transpose();
  EXPECT_NEAR(pair.vector.norm(), 1, 1e-14) << values.transpose();
  EXPECT_LE((tensor * pair.vector - pair.value * pair.vector).norm(), 1e-14 * size)
      << values.transpose();
}

TEST(LargestEigenpair, SolvesRandomTensorsToRounding) {
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const double size = std::pow(10.0, random.uniform(-30, 30));
    const Vec3 values(random.normal(), random.normal(), random.normal());
    expect_largest(size * values, random_axes(random));
  }
}

TEST(LargestEigenpair, SolvesTensorsWhoseEigenvaluesMeetOrAlmostMeet) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    for (const double gap : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
      const Mat3 axes = random_axes(random);
      expect_largest({1, 1 + gap, 0}, axes);        // the two largest
      expect_largest({1, 0, gap}, axes);            // the two smallest
      expect_largest({1, 1 + gap, 1 - gap}, axes);  // all three
      expect_largest({-1, -1 - gap, -2}, axes);
      expect_largest({gap, -1, -1}, axes);
      expect_largest({gap, -gap, 0}, axes);
    }
  }
}

TEST(LargestEigenpair, SolvesTensorsOfATangentPlane) {
  // ς of a flat star has one exact zero: the common case on a plate.
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    expect_largest({random.normal(), random.normal(), 0}, Mat3::Identity());
    expect_largest({random.normal(), random.normal(), 0}, random_axes(random));
  }
}

TEST(LargestEigenpair, OfADiagonalTensorIsExact) {
  for (const Vec3& values : {Vec3(1, 3, 2), Vec3(-1, -3, -2), Vec3(0, 0, 5), Vec3(0, -5, 0)}) {
    const Eigenpair pair = largest_eigenpair({values.x(), values.y(), values.z(), 0, 0, 0});
    int axis = 0;
    values.maxCoeff(&axis);
    EXPECT_NEAR(pair.value, values[axis], 1e-15);
    EXPECT_NEAR((Sym3{values.x(), values.y(), values.z(), 0, 0, 0} * pair.vector -
                 values[axis] * pair.vector)
                    .norm(),
                0, 1e-14);
  }
}

TEST(LargestEigenpair, OfTheZeroTensorIsZeroWithAUnitVector) {
  EXPECT_EQ(largest_eigenpair({}).value, 0);
  EXPECT_EQ(largest_eigenpair({}).vector.norm(), 1);
}

TEST(LargestEigenpair, OfAMultipleOfTheIdentityIsThatMultiple) {
  for (const double c : {3.0, -0.25, 1e-200, 1e200}) {
    const Eigenpair pair = largest_eigenpair({c, c, c, 0, 0, 0});
    EXPECT_DOUBLE_EQ(pair.value, c);
    EXPECT_EQ(pair.vector.norm(), 1);
  }
}

}  // namespace
}  // namespace craze
