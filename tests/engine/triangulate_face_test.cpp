// One face cut along segments: exact, complete, Delaunay where nothing constrains it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <set>
#include <utility>

#include "craze/base/random.h"
#include "craze/engine/asset/triangulate_face.h"

namespace craze {
namespace {

FaceDrawing empty_face() {
  FaceDrawing face;
  face.points = {{0, 0}, {grid, 0}, {0, grid}};
  return face;
}

GridPoint at(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * grid)),
          static_cast<std::int32_t>(std::lround(y * grid))};
}

/// Triangles are turned the right way round and their areas sum to the face's, to the last unit.
void check_tiling(const FaceTriangulator& made) {
  const auto& p = made.points();
  std::int64_t sum = 0;
  std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
  for (std::int32_t k = 0; k < made.triangle_count(); ++k) {
    const Triangle t = made.triangle(k);
    const std::int64_t area = orient(p[t[0]], p[t[1]], p[t[2]]);
    ASSERT_GT(area, 0);
    sum += area;
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(++edges[std::make_pair(t[i], t[(i + 1) % 3])], 1) << "two triangles overlap";
    }
  }
  EXPECT_EQ(sum, std::int64_t{grid} * grid);
}

/// Each segment is a chain of lines that leaves it by no more than the tolerance.
void check_segments(const FaceDrawing& face, const FaceTriangulator& made) {
  const auto& p = made.points();
  std::map<std::int32_t, std::vector<std::int32_t>> beside;
  for (const FaceSegment& line : made.lines()) {
    beside[line.a].push_back(line.b);
    beside[line.b].push_back(line.a);
  }
  for (const FaceSegment& s : face.segments) {
    const std::int32_t a = made.same_as()[s.a], b = made.same_as()[s.b];
    const double x = p[b].x - p[a].x, y = p[b].y - p[a].y, length = std::hypot(x, y);
    // Every bend adds its own tolerance; three are more than any of these cases needs.
    const double slack = 3.0 * face.tolerance;
    std::set<std::int32_t> reached{a};
    std::queue<std::int32_t> queue({a});
    while (!queue.empty()) {
      const std::int32_t v = queue.front();
      queue.pop();
      for (const std::int32_t w : beside[v]) {
        const double off = std::abs(x * (p[w].y - p[a].y) - y * (p[w].x - p[a].x)) / length;
        if (off <= slack && reached.insert(w).second) queue.push(w);
      }
    }
    ASSERT_TRUE(a == b || reached.count(b)) << "segment " << s.label;
  }
  EXPECT_EQ(made.lost(), 0);
}

TEST(TriangulatedFace, SegmentsThatCrossShareAPoint) {
  FaceDrawing face = empty_face();
  face.points.insert(face.points.end(), {at(.1, .1), at(.5, .4), at(.1, .5), at(.6, .1)});
  face.segments = {{3, 4, 0}, {5, 6, 1}};
  FaceTriangulator made;
  made.run(face);
  check_tiling(made);
  check_segments(face, made);
  ASSERT_EQ(made.points().size(), face.points.size() + 1);
  EXPECT_EQ(made.lines().size(), 4u);
}

TEST(TriangulatedFace, ASegmentThatPassesAPointGoesThroughIt) {
  FaceDrawing face = empty_face();
  face.points.insert(face.points.end(), {at(.1, .3), at(.6, .3), at(.3, .3 + 1e-7)});
  face.segments = {{3, 4, 7}};
  FaceTriangulator made;
  made.run(face);
  check_tiling(made);
  ASSERT_EQ(made.lines().size(), 2u);
  for (const FaceSegment& line : made.lines()) EXPECT_TRUE(line.a == 5 || line.b == 5);
}

TEST(TriangulatedFace, SegmentsOfTwoCurvesOnOneLineAreOneLineOfTheFirst) {
  FaceDrawing face = empty_face();
  face.points.insert(face.points.end(), {at(.1, .3), at(.6, .3), at(.2, .3), at(.4, .3)});
  face.segments = {{3, 4, 2}, {5, 6, 1}};
  FaceTriangulator made;
  made.run(face);
  check_segments(face, made);
  ASSERT_EQ(made.lines().size(), 3u);
  for (const FaceSegment& line : made.lines()) {
    const bool common = std::min(line.a, line.b) == 5 && std::max(line.a, line.b) == 6;
    EXPECT_EQ(line.label, common ? 1 : 2);
  }
}

TEST(TriangulatedFace, WithoutSegmentsItIsDelaunayInTheFacesOwnMetric) {
  Random random(3);
  FaceDrawing face = empty_face();
  const Vec2 e(3, 0), g(2.9, 0.2);  // a flat, long face
  face.metric = {e.dot(e), e.dot(g), g.dot(g)};
  while (face.points.size() < 200) {
    const double x = random.uniform(), y = random.uniform();
    if (x > 0.001 && y > 0.001 && x + y < 0.999) face.points.push_back(at(x, y));
  }
  FaceTriangulator made;
  made.run(face);
  check_tiling(made);
  const auto place = [&](std::int32_t p) -> Vec2 {
    return (made.points()[p].x * e + made.points()[p].y * g) / grid;
  };
  std::map<std::pair<std::int32_t, std::int32_t>, double> angle;
  for (std::int32_t k = 0; k < made.triangle_count(); ++k) {
    const Triangle t = made.triangle(k);
    for (int i = 0; i < 3; ++i) {
      const Vec2 u = place(t[i]) - place(t[(i + 2) % 3]),
                 v = place(t[(i + 1) % 3]) - place(t[(i + 2) % 3]);
      angle[std::minmax(t[i], t[(i + 1) % 3])] +=
          std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    }
  }
  int inner = 0;
  std::map<std::pair<std::int32_t, std::int32_t>, int> sides;
  for (std::int32_t k = 0; k < made.triangle_count(); ++k) {
    const Triangle t = made.triangle(k);
    for (int i = 0; i < 3; ++i) ++sides[std::minmax(t[i], t[(i + 1) % 3])];
  }
  for (const auto& [ends, sum] : angle) {
    if (sides[ends] != 2) continue;
    ++inner;
    EXPECT_LE(sum, std::numbers::pi + 1e-6);
  }
  EXPECT_GT(inner, 400);
}

TEST(TriangulatedFace, RandomPointsAndSegmentsTileItExactly) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    FaceDrawing face = empty_face();
    face.tolerance = seed % 2 == 0 ? 1 << 10 : 1 << 18;
    for (int i = 0; i < 3; ++i) {
      std::set<std::int32_t> on;
      for (std::uint64_t k = random.below(6); k > 0; --k) {
        on.insert(static_cast<std::int32_t>(1000 + random.below(1000)) * (grid / 3000));
      }
      for (const std::int32_t s : on) face.points.push_back(on_grid_edge(i, s));
      face.on_edge[i] = static_cast<std::int32_t>(on.size());
    }
    // Few distinct coordinates: points in line and equal ones are common.
    const auto cells = static_cast<std::int32_t>(4 + random.below(20));
    for (std::uint64_t k = random.below(40); k > 0; --k) {
      const double x = 1.0 + random.below(cells), y = 1.0 + random.below(cells);
      face.points.push_back(at(x / (2 * cells + 4), y / (2 * cells + 4)));
    }
    const std::uint64_t points = face.points.size();
    for (std::uint64_t k = random.below(40); k > 0; --k) {
      face.segments.push_back({static_cast<std::int32_t>(random.below(points)),
                               static_cast<std::int32_t>(random.below(points)),
                               static_cast<std::int32_t>(k)});
    }
    FaceTriangulator made;
    made.run(face);
    check_tiling(made);
    check_segments(face, made);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace craze
