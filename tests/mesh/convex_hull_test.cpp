#include "craze/mesh/convex_hull.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>

#include "craze/mesh/mass_properties.h"
#include "craze/shapes.h"

namespace craze {
namespace {

void expect_closed(const ConvexHull& hull) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> uses;
  for (const Triangle& t : hull.triangles) {
    for (int i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(uses.count({edge.second, edge.first}), 1U);
  }
}

/// How far outside of a face the farthest of the points is.
double farthest_outside(const ConvexHull& hull, const std::vector<Vec3>& points) {
  double most = 0;
  for (const Triangle& t : hull.triangles) {
    const Vec3 &a = hull.positions[t[0]], &b = hull.positions[t[1]], &c = hull.positions[t[2]];
    const Vec3 n = (b - a).cross(c - a).normalized();
    for (const Vec3& p : points) most = std::max(most, n.dot(p - a));
  }
  return most;
}

TEST(ConvexHull, OfACubeHasItsEightCornersHoweverManyPointsLieOnItsFaces) {
  std::vector<Vec3> points;
  for (int x = 0; x <= 6; ++x) {
    for (int y = 0; y <= 6; ++y) {
      for (int z = 0; z <= 6; ++z) points.emplace_back(x, y, z);
    }
  }
  const ConvexHull hull = convex_hull(points);
  expect_closed(hull);
  EXPECT_EQ(hull.positions.size(), 8U);
  EXPECT_NEAR(mass_properties(hull.positions, hull.triangles).volume, 216, 1e-9);
}

TEST(ConvexHull, HoldsAllPointsAndIsClosed) {
  EXPECT_TRUE(rc::check([] {
    const auto count = *rc::gen::inRange<std::size_t>(4, 40);
    const auto numbers =
        *rc::gen::container<std::vector<int>>(3 * count, rc::gen::inRange(-50, 50));
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) {
      points.emplace_back(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    }
    const ConvexHull hull = convex_hull(points);
    if (hull.triangles.empty()) return;  // in a plane
    expect_closed(hull);
    RC_ASSERT(!testing::Test::HasFailure());
    RC_ASSERT(farthest_outside(hull, points) < 1e-6);
    RC_ASSERT(mass_properties(hull.positions, hull.triangles).volume > 0);
  }));
}

TEST(ConvexHull, OfManyVerticesIsNearlyTheTrueOneWithFew) {
  const std::vector<Vec3> points = make_shape("sphere?n=8").positions;
  const ConvexHull hull = convex_hull(points, 64), whole = convex_hull(points, 100000);
  expect_closed(hull);
  expect_closed(whole);
  EXPECT_LE(hull.positions.size(), 64U);
  const double volume = mass_properties(hull.positions, hull.triangles).volume;
  const double all = mass_properties(whole.positions, whole.triangles).volume;
  EXPECT_LT(volume, all);
  EXPECT_GT(volume, 0.85 * all);
}

TEST(ConvexHull, OfWhatIsFlatOrLessHasNoFaces) {
  EXPECT_TRUE(convex_hull({}).triangles.empty());
  EXPECT_TRUE(convex_hull({Vec3(1, 2, 3)}).triangles.empty());
  EXPECT_TRUE(convex_hull({Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)}).triangles.empty());
  EXPECT_TRUE(convex_hull(make_shape("plate?n=6").positions).triangles.empty());
}

}  // namespace
}  // namespace craze
