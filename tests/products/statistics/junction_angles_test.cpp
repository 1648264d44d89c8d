#include "craze/products/statistics/measures/junction_angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/base/random.h"
#include "craze/products/statistics/graph/plane_frame.h"

namespace craze {
namespace {

using std::numbers::pi;

/// A T as a skeleton shows it: the crossbar is drawn toward the leg near the junction, and every
/// point is off by some noise. Branches leave (0, −pull).
struct BlurredT {
  std::vector<Vec3> branch[3];

  explicit BlurredT(std::uint64_t seed) {
    constexpr double pull = 0.07, reach = 0.05, noise = 0.006, step = 0.01;
    Random random(seed);
    for (int side = 0; side < 2; ++side) {
      for (int i = 0; i < 60; ++i) {
        const double x = i * step;
        const double y = -pull * std::exp(-x / reach) + (i ? noise * random.normal() : 0);
        branch[side].emplace_back(side == 0 ? x : -x, y, 0);
      }
    }
    for (int i = 0; i < 60; ++i) {
      branch[2].emplace_back(i ? noise * random.normal() : 0, -pull - i * step, 0);
    }
  }

  template <class Direction>
  double largest_angle(Direction direction) const {
    double angle[3];
    for (int i = 0; i < 3; ++i) angle[i] = direction(branch[i]);
    std::sort(angle, angle + 3);
    return std::max({angle[1] - angle[0], angle[2] - angle[1], angle[0] + 2 * pi - angle[2]}) *
           180 / pi;
  }
};

double averaged_unit_vectors(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i < points.size() && i <= 40; ++i) {
    sum += (points[i] - points[0]).normalized();
  }
  return std::atan2(sum.y(), sum.x());
}

TEST(JunctionAngles, LineFitsSeeATWhereAveragedUnitVectorsSeeAY) {
  double fitted = 0, averaged = 0;
  constexpr int repeats = 200;
  const Mat32 frame = plane_frame(Vec3::UnitZ());
  for (int k = 0; k < repeats; ++k) {
    const BlurredT t(k + 1);
    fitted += t.largest_angle([&](const std::vector<Vec3>& b) {
      return branch_direction(b, Vec3::UnitZ(), frame, {0.1, 0.45});
    }) / repeats;
    averaged += t.largest_angle(averaged_unit_vectors) / repeats;
  }
  EXPECT_GT(fitted, 170);
  EXPECT_LT(fitted, 190);
  EXPECT_LT(averaged, 160);
}

TEST(JunctionAngles, AStraightBranchHasItsOwnDirection) {
  for (const double angle : {0.1, 1.6, 3.0, -2.0}) {
    const Vec3 along(std::cos(angle), std::sin(angle), 0);
    const double fitted = branch_direction({{0, 0, 0}, 0.01 * along, 0.2 * along}, Vec3::UnitZ(),
                                           plane_frame(Vec3::UnitZ()), {0.05, 5});
    EXPECT_NEAR(std::remainder(fitted - angle, 2 * pi), 0, 1e-12);
  }
}

TEST(JunctionAngles, ShapesAreToldApartByTheirTolerance) {
  const auto shape = [](double a, double b, double tolerance) {
    return junction_shape({a * pi / 180, b * pi / 180, (360 - a - b) * pi / 180},
                          tolerance * pi / 180);
  };
  EXPECT_EQ(shape(90, 90, 20), JunctionShape::t);
  EXPECT_EQ(shape(60, 105, 20), JunctionShape::t) << "195 is within 20 of 180";
  EXPECT_EQ(shape(90, 111, 20), JunctionShape::mixed) << "159 is not";
  EXPECT_EQ(shape(120, 120, 20), JunctionShape::y);
  EXPECT_EQ(shape(101, 139, 20), JunctionShape::y);
  EXPECT_EQ(shape(99, 130, 20), JunctionShape::mixed);
}

/// A unit sphere's great-circle arc from a, in `steps` pieces.
std::vector<Vec3> arc(const Vec3& a, const Vec3& b, int steps) {
  std::vector<Vec3> points;
  for (int i = 0; i <= steps; ++i) {
    points.push_back((a + (b - a) * (static_cast<double>(i) / steps)).normalized());
  }
  return points;
}

TEST(JunctionAngles, OfAJunctionOnABumpAreThoseOfTheSurfaceAround) {
  CrackGraphInput input;
  const auto add = [&](const Vec3& p) {
    input.points.push_back(p);
    input.normals.push_back(Vec3::UnitZ());
    return static_cast<std::int32_t>(input.points.size()) - 1;
  };
  const std::int32_t middle = add(Vec3::Zero());
  input.normals[0] = Vec3(1, 0.7, 0.3).normalized();  // one bump's
  for (const Vec3& way : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0)}) {
    std::int32_t last = middle;
    for (int i = 1; i <= 40; ++i) {
      const std::int32_t next = add(0.01 * i * way);
      GraphInputEdge edge;
      edge.a = last;
      edge.b = next;
      input.edges.push_back(edge);
      last = next;
    }
  }
  const CrackGraph graph(input);
  std::int32_t node = 0;
  while (graph.degree(node) != 3) ++node;
  std::vector<double> sectors = sector_angles(graph, node, {0.05, 0.4});
  std::sort(sectors.begin(), sectors.end());
  EXPECT_NEAR(sectors[0], pi / 2, 0.01);
  EXPECT_NEAR(sectors[1], pi / 2, 0.01);
  EXPECT_NEAR(sectors[2], pi, 0.01);
}

TEST(JunctionAngles, AMeridianMeetsTheEquatorAtARightAngle) {
  const Vec3 node(1, 0, 0);
  const Mat32 frame = plane_frame(node);
  const BranchFit fit{0.05, 0.6};
  const double east = branch_direction(arc(node, {0, 1, 0}, 30), node, frame, fit);
  const double west = branch_direction(arc(node, {0, -1, 0}, 30), node, frame, fit);
  const double north = branch_direction(arc(node, {0, 0, 1}, 30), node, frame, fit);
  EXPECT_NEAR(std::abs(std::remainder(east - west, 2 * pi)), pi, 1e-9);
  EXPECT_NEAR(std::abs(std::remainder(north - west, 2 * pi)), pi / 2, 1e-9);
}

}  // namespace
}  // namespace craze
