#include "craze/products/statistics/graph/simplify_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "craze/base/random.h"
#include "craze/base/segment_distance.h"

namespace craze {
namespace {

std::int32_t add_point(CrackGraphInput& graph, const Vec3& p) {
  graph.points.push_back(p);
  graph.normals.push_back(Vec3::UnitZ());
  return static_cast<std::int32_t>(graph.points.size()) - 1;
}

void join(CrackGraphInput& graph, std::int32_t a, std::int32_t b) {
  GraphInputEdge edge;
  edge.a = a;
  edge.b = b;
  graph.edges.push_back(edge);
}

double length(const CrackGraphInput& graph) {
  double sum = 0;
  for (const GraphInputEdge& e : graph.edges) {
    sum += (graph.points[e.a] - graph.points[e.b]).norm();
  }
  return sum;
}

/// A straight line from the origin as pixels draw it.
CrackGraphInput drawn_by_pixels(double angle, int pixels) {
  CrackGraphInput graph;
  std::int32_t last = add_point(graph, Vec3::Zero());
  for (double t = 0.25; t < pixels; t += 0.25) {
    const Vec3 p(std::round(t * std::cos(angle)), std::round(t * std::sin(angle)), 0);
    if (p == graph.points[last]) continue;
    const std::int32_t next = add_point(graph, p);
    join(graph, last, next);
    last = next;
  }
  return graph;
}

TEST(SimplifyLines, TakesTheStepsOutOfLinesThatPixelsDraw) {
  double longest = 0;
  for (int degrees = 3; degrees < 90; degrees += 7) {
    CrackGraphInput graph = drawn_by_pixels(degrees * std::numbers::pi / 180, 80);
    const double straight = (graph.points.back() - graph.points.front()).norm();
    longest = std::max(longest, length(graph) / straight);
    simplify_lines(graph, 1);
    EXPECT_NEAR(length(graph) / straight, 1, 0.005) << degrees;
  }
  EXPECT_GT(longest, 1.07) << "there was something to take out";
}

TEST(SimplifyLines, NothingIsFartherFromItsLineThanTheTolerance) {
  Random random(1);
  CrackGraphInput graph;
  std::int32_t last = add_point(graph, Vec3::Zero());
  for (int i = 1; i < 400; ++i) {
    const std::int32_t next = add_point(graph, Vec3(i, 5 * random.normal(), random.normal()));
    join(graph, last, next);
    last = next;
  }
  const CrackGraphInput before = graph;
  for (const double tolerance : {0.5, 3.0, 20.0}) {
    graph = before;
    simplify_lines(graph, tolerance);
    EXPECT_LT(graph.edges.size(), before.edges.size());
    for (const Vec3& p : before.points) {
      double nearest = 1e300;
      for (const GraphInputEdge& e : graph.edges) {
        const Vec3 a = graph.points[e.a], b = graph.points[e.b];
        nearest = std::min(nearest, point_segment_distance(p, a, b));
      }
      EXPECT_LE(nearest, tolerance * (1 + 1e-12));
    }
  }
}

/// A cross whose arms bend a little, with a ring around it, and two lines between the same points.
CrackGraphInput bent_cross() {
  CrackGraphInput graph;
  const std::int32_t middle = add_point(graph, Vec3::Zero());
  for (const Vec3& arm : {Vec3(4, 0, 0), Vec3(-4, 0, 0), Vec3(0, 4, 0), Vec3(0, -4, 0)}) {
    const std::int32_t bend = add_point(graph, 0.5 * arm + Vec3(0.1, 0.1, 0));
    join(graph, middle, bend);
    join(graph, bend, add_point(graph, arm));
  }
  const auto ring = static_cast<std::int32_t>(graph.points.size());
  for (int i = 0; i < 40; ++i) {
    const double a = 2 * std::numbers::pi * i / 40;
    add_point(graph, {9 * std::cos(a), 9 * std::sin(a), 0});
  }
  for (int i = 0; i < 40; ++i) join(graph, ring + i, ring + (i + 1) % 40);
  const std::int32_t a = add_point(graph, {20, 0, 0}), b = add_point(graph, {24, 0, 0});
  for (const double y : {0.1, -0.1}) {
    const std::int32_t bend = add_point(graph, {22, y, 0});
    join(graph, a, bend);
    join(graph, bend, b);
  }
  join(graph, a, add_point(graph, {19, 0, 0}));
  join(graph, b, add_point(graph, {25, 0, 0}));
  return graph;
}

std::map<std::int32_t, int> degrees_of(const CrackGraphInput& graph) {
  std::map<std::int32_t, int> degrees;
  for (const GraphInputEdge& e : graph.edges) {
    ++degrees[e.a];
    ++degrees[e.b];
  }
  return degrees;
}

TEST(SimplifyLines, JunctionsEndsRingsAndTwinsStay) {
  const CrackGraphInput before = bent_cross();
  for (const double tolerance : {0.2, 1.0, 100.0}) {
    CrackGraphInput graph = before;
    simplify_lines(graph, tolerance);
    EXPECT_LT(graph.edges.size(), before.edges.size());
    const std::map<std::int32_t, int> now = degrees_of(graph);
    for (const auto& [point, degree] : degrees_of(before)) {
      if (degree != 2) {
        EXPECT_EQ(now.at(point), degree);
      }
    }
    std::map<std::pair<std::int32_t, std::int32_t>, int> count;
    for (const GraphInputEdge& e : graph.edges) {
      EXPECT_NE(e.a, e.b);
      EXPECT_EQ(++count[std::minmax(e.a, e.b)], 1);
    }
    EXPECT_GE(std::count_if(now.begin(), now.end(),
                            [&](const auto& entry) {
                              return std::abs(graph.points[entry.first].norm() - 9) < 1e-9;
                            }),
              3);
  }
}

TEST(SimplifyLines, BordersAndChangesOfTimeStay) {
  CrackGraphInput graph;
  for (int i = 0; i <= 8; ++i) add_point(graph, Vec3(i, 0, 0));
  for (int i = 0; i < 8; ++i) join(graph, i, i + 1);
  for (int i = 0; i < 3; ++i) graph.edges[i].time = 1;
  for (int i = 3; i < 5; ++i) graph.edges[i].time = 2;
  for (int i = 5; i < 8; ++i) graph.edges[i].border = true;
  simplify_lines(graph, 0.5);
  ASSERT_EQ(graph.edges.size(), 5U);
  EXPECT_EQ(std::count_if(graph.edges.begin(), graph.edges.end(),
                          [](const GraphInputEdge& e) { return e.border; }),
            3);
  const auto has = [&](std::int32_t a, std::int32_t b, double time) {
    return std::any_of(graph.edges.begin(), graph.edges.end(), [&](const GraphInputEdge& e) {
      return std::minmax(e.a, e.b) == std::minmax(a, b) && e.time == time;
    });
  };
  EXPECT_TRUE(has(0, 3, 1));
  EXPECT_TRUE(has(3, 5, 2));
}

TEST(SimplifyLines, ZeroChangesNothing) {
  const CrackGraphInput before = bent_cross();
  CrackGraphInput graph = before;
  simplify_lines(graph, 0);
  ASSERT_EQ(graph.edges.size(), before.edges.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    EXPECT_EQ(graph.edges[e].a, before.edges[e].a);
    EXPECT_EQ(graph.edges[e].b, before.edges[e].b);
  }
}

}  // namespace
}  // namespace craze
