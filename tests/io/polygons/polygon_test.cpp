#include "craze/io/polygons/polygon.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <chrono>
#include <numbers>

#include "craze/base/random.h"

namespace craze {
namespace {

/// Area along the normal: negative for triangles that face the other way.
double area(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  return 0.5 * (b - a).cross(c - a).dot(normal);
}

/// A star-shaped polygon of n corners at random radii, in a random plane.
struct Star {
  Star(int n, std::uint64_t seed) {
    Random random(seed);
    normal = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
    const Vec3 center(random.normal(), random.normal(), random.normal());
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, r = random.uniform(0.05, 1);
      corners.push_back(center + r * (std::cos(angle) * x + std::sin(angle) * y));
    }
    for (int i = 0; i < n; ++i) outline += area(center, corners[i], corners[(i + 1) % n], normal);
  }
  std::vector<Vec3> corners;
  Vec3 normal;
  double outline = 0;  ///< the polygon's area
};

TEST(Polygon, EarsTileConcavePolygonsWithoutOverlap) {
  const bool holds = rc::check("n - 2 triangles, none turned over, of the polygon's area", [] {
    const int n = *rc::gen::inRange(4, 60);
    const Star star(n, *rc::gen::arbitrary<std::uint64_t>());
    std::vector<CornerTriple> triangles;
    RC_ASSERT(triangulate_polygon(star.corners, triangles));
    RC_ASSERT(triangles.size() == static_cast<std::size_t>(n - 2));
    double sum = 0;
    for (const auto& t : triangles) {
      const double a =
          area(star.corners[t[0]], star.corners[t[1]], star.corners[t[2]], star.normal);
      RC_ASSERT(a > -1e-12);
      sum += a;
    }
    RC_ASSERT(std::abs(sum - star.outline) < 1e-9);
  });
  EXPECT_TRUE(holds);
}

TEST(Polygon, ConvexOnesBecomeFansOfAnySize) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 20000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 20000;
    corners.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  std::vector<CornerTriple> triangles;
  ASSERT_TRUE(triangulate_polygon(corners, triangles));
  EXPECT_EQ(triangles.back(), (CornerTriple{0, 19998, 19999}));
}

TEST(Polygon, ADartIsCutAtItsReflexCorner) {
  const std::vector<Vec3> dart{{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}};
  std::vector<CornerTriple> triangles;
  ASSERT_TRUE(triangulate_polygon(dart, triangles));
  for (const auto& t : triangles) {
    EXPECT_GT(area(dart[t[0]], dart[t[1]], dart[t[2]], Vec3::UnitZ()), 0);
  }
}

TEST(Polygon, OutlinesThatCrossThemselvesOrHaveNoAreaStillEnd) {
  std::vector<CornerTriple> triangles;
  EXPECT_TRUE(triangulate_polygon(
      std::vector<Vec3>{{0, 0, 0}, {3, 1, 0}, {3, 0, 0}, {0, 2, 0}, {1, 5, 0}}, triangles));
  EXPECT_TRUE(triangulate_polygon(std::vector<Vec3>(5, Vec3(1, 1, 1)), triangles));
  EXPECT_EQ(triangles.size(), 6u);
}

TEST(Polygon, TheLargestConcaveOneTakesMilliseconds) {
  const Star star(max_concave_corners, 5);
  std::vector<CornerTriple> triangles;
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(triangulate_polygon(star.corners, triangles));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 3) << "generous, for sanitizers";
  EXPECT_FALSE(triangulate_polygon(Star(max_concave_corners + 1, 5).corners, triangles));
}

}  // namespace
}  // namespace craze
