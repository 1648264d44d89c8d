#include "craze/mesh/self_intersection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "products/distance/surfaces.h"

namespace craze {
namespace {

using Pairs = std::vector<std::array<std::int32_t, 2>>;

TEST(SelfIntersection, TwoTrianglesThatCrossAreFoundWhicheverIsFirst) {
  const std::vector<Vec3> p{{0, 0, 0},      {1, 0, 0},     {0, 1, 0},
                            {0.2, 0.2, -1}, {0.2, 0.2, 1}, {3, 3, 0}};
  EXPECT_EQ(self_intersections(p, {{0, 1, 2}, {3, 4, 5}}), (Pairs{{0, 1}}));
  EXPECT_EQ(self_intersections(p, {{5, 4, 3}, {1, 0, 2}}), (Pairs{{0, 1}}));
}

TEST(SelfIntersection, TouchingIsNoCrossing) {
  // A corner on the inside, an edge on the inside, one plane.
  const std::vector<Vec3> p{{0, 0, 0},     {1, 0, 0},     {0, 1, 0},     {0.2, 0.2, 0},
                            {0.2, 0.2, 1}, {1, 1, 1},     {0.1, 0.1, 0}, {0.6, 0.1, 0},
                            {0.3, 0.1, 1}, {0.1, 0.2, 0}, {2, 2, 0},     {0.4, -1, 0}};
  EXPECT_TRUE(self_intersections(p, {{0, 1, 2}, {3, 4, 5}}).empty());
  EXPECT_TRUE(self_intersections(p, {{0, 1, 2}, {6, 7, 8}}).empty());
  EXPECT_TRUE(self_intersections(p, {{0, 1, 2}, {9, 10, 11}}).empty());
}

TEST(SelfIntersection, TrianglesThatShareACornerCrossWhereTheOppositeEdgeGoesThrough) {
  const std::vector<Vec3> p{{0, 0, 0},     {2, 0, 0}, {0, 2, 0},  {0.5, 0.5, -1},
                            {0.5, 0.5, 1}, {0, 0, 0}, {-1, 0, 1}, {-1, 0, -1}};
  EXPECT_EQ(self_intersections(p, {{0, 1, 2}, {0, 3, 4}}).size(), 1u) << "by index";
  EXPECT_EQ(self_intersections(p, {{0, 1, 2}, {5, 3, 4}}).size(), 1u) << "by place";
  EXPECT_TRUE(self_intersections(p, {{0, 1, 2}, {0, 6, 7}}).empty());
}

TEST(SelfIntersection, TrianglesThatShareACornerCrossWhereTheirOppositeEdgesMeet) {
  // Walls that stand on one point below, whose rims cross in the plane above.
  const std::vector<Vec3> p{{0.3, 0.2, -1}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0},
                            {0, 1, 0},      {1, 1, 0},  {0, 0, 0}, {-0.3, -0.2, 1}};
  for (const Triangle& s : {Triangle{0, 1, 2}, Triangle{1, 2, 0}, Triangle{2, 1, 0}}) {
    for (const Triangle& t : {Triangle{0, 3, 4}, Triangle{4, 0, 3}, Triangle{4, 3, 0}}) {
      EXPECT_EQ(self_intersections(p, {s, t}).size(), 1u);
    }
  }
  EXPECT_TRUE(self_intersections(p, {{0, 1, 2}, {0, 4, 5}}).empty()) << "they are apart";
  EXPECT_TRUE(self_intersections(p, {{0, 1, 2}, {0, 4, 6}}).empty()) << "they touch";
  EXPECT_TRUE(self_intersections(p, {{0, 1, 2}, {7, 3, 4}}).empty()) << "they share no corner";
}

TEST(SelfIntersection, PartsOfASheetThatLieOverEachOtherCross) {
  // On a plane that no axis lies in, the third corner of two triangles that share a corner.
  const Vec3 a = Vec3(2, 1, -1).normalized(), b = Vec3(1, -1, 1).normalized(), o(0.3, 0.1, 0.7);
  const auto at = [&](double x, double y) { return Vec3(o + x * a + y * b); };
  const std::vector<Vec3> p{at(0, 0), at(1, 0),  at(0, 1),   at(0.4, 0.4), at(2, 0.4), at(2, 2),
                            at(1, 1), at(-1, 1), at(0.1, 1), at(0.5, 0.5), at(3, 0.5)};
  const auto pairs = [&](const std::vector<Triangle>& triangles, std::int32_t sheet_end) {
    return SelfIntersections(triangles, SIZE_MAX, sheet_end).at(p, {}).size();
  };
  const Triangle t{0, 1, 2};
  EXPECT_EQ(pairs({t, {3, 4, 5}}, 2), 1u);
  EXPECT_EQ(pairs({t, {3, 4, 5}}, 1), 0u) << "one is no part of the sheet";
  EXPECT_EQ(pairs({t, {3, 5, 4}}, 2), 0u) << "turned the other way";
  EXPECT_EQ(pairs({t, {0, 3, 8}}, 2), 1u) << "they share a corner";
  EXPECT_EQ(pairs({t, {2, 7, 0}}, 2), 0u) << "they share an edge";
  EXPECT_EQ(pairs({t, {1, 6, 2}}, 2), 0u) << "they share an edge";
  EXPECT_EQ(pairs({t, {9, 10, 5}}, 2), 0u) << "they touch";
}

TEST(SelfIntersection, ASoundSurfaceHasNone) {
  const TriangleMesh torus = test::torus(40);
  EXPECT_TRUE(self_intersections(torus.positions(), torus.triangles()).empty());
  TriangleMesh cut = test::plate(20, 0.3);
  test::cut_at_random(cut, 500, 2, 4);
  SelfIntersections crossings(cut.triangles(), SIZE_MAX, cut.face_count());
  EXPECT_TRUE(crossings.at(cut.positions(), {}).empty()) << "the two sides of a shut crack";
}

TEST(SelfIntersection, ATreeFindsWhatComparingAllPairsFinds) {
  Random random(5);
  std::vector<Vec3> p;
  std::vector<Triangle> t;
  for (std::int32_t f = 0; f < 120; ++f) {
    const Vec3 at(random.uniform(), random.uniform(), random.uniform());
    for (int i = 0; i < 3; ++i) {
      p.push_back(at + 0.15 * Vec3(random.normal(), random.normal(), random.normal()));
    }
    t.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  Pairs expected;
  for (std::int32_t f = 0; f < 120; ++f) {
    for (std::int32_t g = f + 1; g < 120; ++g) {
      if (!self_intersections(p, {t[f], t[g]}).empty()) expected.push_back({f, g});
    }
  }
  EXPECT_GT(expected.size(), 20u);
  EXPECT_EQ(self_intersections(p, t), expected);
  EXPECT_EQ(self_intersections(p, t, 7).size(), 7u);
}

TEST(SelfIntersection, WhatIsAskedAgainAfterSomeHasMovedIsWhatAskingAnewSays) {
  Random random(6);
  const auto normal = [&] { return Vec3(random.normal(), random.normal(), random.normal()); };
  constexpr std::int32_t count = 6000;  // more than one task
  std::vector<Vec3> p;
  std::vector<Triangle> t;
  for (std::int32_t f = 0; f < count; ++f) {
    const Vec3 at(random.uniform(), random.uniform(), random.uniform());
    for (int i = 0; i < 3; ++i) p.emplace_back(at + 0.02 * normal());
    t.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  const Pairs all = self_intersections(p, t);
  ASSERT_GT(all.size(), 500u);
  for (const std::size_t limit : {std::size_t{SIZE_MAX}, all.size() + 20, all.size() / 2}) {
    for (const int threads : {1, 3}) {
      Context context;
      context.threads = threads;
      SelfIntersections crossings(t, limit);
      std::vector<Vec3> moved = p;
      for (int round = 0; round < 12; ++round) {
        EXPECT_EQ(crossings.at(moved, context), self_intersections(moved, t, limit))
            << threads << " " << limit << " " << round;
        for (int n = 0; n < 40 * round; ++n) {
          moved[static_cast<std::size_t>(random.uniform() * 3 * count)] += 0.02 * normal();
        }
      }
    }
  }
}

TEST(SelfIntersection, ACancelledQuestionIsAskedAnew) {
  const TriangleMesh plate = test::plate(60, 0);
  std::vector<Vec3> folded = plate.positions();
  for (Vec3& p : folded) {
    p.z() = (p.x() - 0.4) * std::sin(20 * p.y());
    p.x() = std::abs(p.x() - 0.4);
  }
  SelfIntersections crossings(plate.triangles(), SIZE_MAX);
  Context impatient;
  EXPECT_TRUE(crossings.at(plate.positions(), impatient).empty());
  impatient.cancelled = [] { return true; };
  EXPECT_THROW(crossings.at(folded, impatient), Cancelled);
  EXPECT_EQ(crossings.at(folded, {}), self_intersections(folded, plate.triangles()));
  EXPECT_FALSE(crossings.at(folded, {}).empty());
}

}  // namespace
}  // namespace craze
