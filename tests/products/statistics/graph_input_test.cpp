#include "craze/products/statistics/graph/graph_input.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <utility>

#include "craze/error.h"
#include "craze/products/statistics/measures/pattern.h"
#include "craze/products/statistics/null_models/null_models.h"
#include "craze/products/statistics/statistics.h"

namespace craze {
namespace {

/// A plate of n × n squares, cut all through along row n/2 and then from its middle up to the top.
struct CutPlate {
  static constexpr int n = 8;
  TriangleMesh mesh;
  CrackNetwork network;

  CutPlate() {
    std::vector<Vec3> p;
    std::vector<Triangle> t;
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) p.emplace_back(i, j, 0);
    }
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
        t.push_back({a, b, c});
        t.push_back({a, c, d});
      }
    }
    mesh = TriangleMesh(p, t);
    for (int i = 0; i < n; ++i) cut({i + 0.0, n / 2.0}, {i + 1.0, n / 2.0}, 0);
    for (int j = n / 2; j < n; ++j) cut({n / 2.0, j + 0.0}, {n / 2.0, j + 1.0}, 1);
  }

  void cut(const Vec2& a, const Vec2& b, std::int32_t event) {
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      if (mesh.position(mesh.from(h)).head<2>() != a) continue;
      if (mesh.position(mesh.to(h)).head<2>() != b || mesh.is_open(h)) continue;
      mesh.cut(h, event);
      break;
    }
    CrackEdge edge;
    edge.a = node(a);
    edge.b = node(b);
    edge.event = event;
    edge.time = 1 + event;
    network.edges.push_back(edge);
  }

  std::int32_t node(const Vec2& p) {
    for (std::size_t i = 0; i < network.nodes.size(); ++i) {
      if (network.nodes[i].position.head<2>() == p) return static_cast<std::int32_t>(i);
    }
    network.nodes.push_back({{p.x(), p.y(), 0}, Vec3::UnitZ(), 0, JunctionKind::bend});
    return static_cast<std::int32_t>(network.nodes.size()) - 1;
  }
};

void expect_cut_plate(const CrackGraphInput& graph, bool with_times) {
  EXPECT_DOUBLE_EQ(graph.surface_area, 64);
  std::vector<double> areas = graph.piece_areas;
  std::sort(areas.begin(), areas.end());
  EXPECT_EQ(areas, (std::vector<double>{16, 16, 32}));
  const auto border = std::count_if(graph.edges.begin(), graph.edges.end(),
                                    [](const GraphInputEdge& e) { return e.border; });
  EXPECT_EQ(border, 32);
  EXPECT_EQ(graph.edges.size(), 32u + 12u);
  for (const GraphInputEdge& e : graph.edges) {
    if (e.border) continue;
    // The whole lower half lies on one side of the first crack, half the upper one on the other.
    const Vec3 d = graph.points[e.b] - graph.points[e.a];
    ASSERT_GE(e.left_piece, 0);
    ASSERT_GE(e.right_piece, 0);
    const double left = graph.piece_areas[e.left_piece];
    const double right = graph.piece_areas[e.right_piece];
    const double below = d.x() > 0 ? right : left, above = d.x() > 0 ? left : right;
    EXPECT_EQ(above, 16);
    EXPECT_EQ(below, d.y() == 0 ? 32 : 16);
  }
  StatisticsOptions o;
  o.border_margin = 0;
  const Statistics s = compute_statistics(graph, o);
  EXPECT_EQ(s.junctions, 1);
  EXPECT_EQ(s.t_fraction.value, 1);
  EXPECT_EQ(s.cells_found, 3);
  EXPECT_DOUBLE_EQ(s.crack_length, 12);
  if (with_times) {
    EXPECT_EQ(s.leg_younger.value, 1);
  } else {
    EXPECT_TRUE(std::isnan(s.leg_younger.value));
  }
}

TEST(GraphInput, ARunKnowsItsBorderPiecesAndTimes) {
  const CutPlate plate;
  expect_cut_plate(graph_from_network(plate.network, plate.mesh), true);
}

TEST(GraphInput, ACrackedMeshGivesItsCracksBack) {
  const CutPlate plate;
  SurfaceMesh surface;
  surface.positions = plate.mesh.positions();
  surface.triangles = plate.mesh.triangles();
  expect_cut_plate(graph_from_cut_mesh(surface), false);
}

TEST(GraphInput, TheBorderOfAPlateIsItsWindow) {
  const CutPlate plate;
  CrackGraphInput graph = graph_from_network(plate.network, plate.mesh);
  const auto window = find_window(graph);
  ASSERT_TRUE(window);
  EXPECT_TRUE(window->drawn);
  EXPECT_DOUBLE_EQ(window->area(), 64);
  for (Vec3& p : graph.points) p = Vec3(p.x() + 0.3 * p.y(), p.y(), 0);  // now a rhomboid
  EXPECT_FALSE(find_window(graph));
}

TEST(GraphInput, ASkeletonIsSeenThroughTheBoxAroundIt) {
  LineSet lines;
  lines.points = {{0, 0, 0}, {3, 0, 0}, {3, 0, 0}, {3, 2, 0}};
  lines.edges = {{0, 1}, {2, 3}, {1, 2}, {1, 0}};
  const CrackGraphInput graph = graph_from_lines(lines);
  EXPECT_EQ(graph.points.size(), 3u) << "equal points are one";
  EXPECT_EQ(graph.edges.size(), 2u) << "what joins them is none, a repeated edge one";
  const auto window = find_window(graph);
  ASSERT_TRUE(window);
  EXPECT_FALSE(window->drawn);
  EXPECT_DOUBLE_EQ(window->area(), 6);
}

/// Pixels on the lines of a grid of squares, each joined with all of its eight neighbours.
LineSet pixel_grid(int squares, int step) {
  LineSet lines;
  std::map<std::pair<int, int>, std::int32_t> pixel;
  for (int y = 0; y <= squares * step; ++y) {
    for (int x = 0; x <= squares * step; ++x) {
      if (x % step != 0 && y % step != 0) continue;
      pixel[{x, y}] = static_cast<std::int32_t>(lines.points.size());
      lines.points.emplace_back(x, y, 0);
    }
  }
  for (const auto& [place, index] : pixel) {
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
      const auto other = pixel.find({place.first + dx, place.second + dy});
      if (other != pixel.end()) lines.edges.push_back({index, other->second});
    }
  }
  return lines;
}

TEST(GraphInput, DiagonalsOfAPixelSkeletonMakeNoCells) {
  const CrackGraphInput graph = graph_from_lines(pixel_grid(4, 10));
  for (const GraphInputEdge& e : graph.edges) {
    EXPECT_DOUBLE_EQ((graph.points[e.a] - graph.points[e.b]).norm(), 1);
  }
  // Euler: faces of a connected planar graph, the outer one left out.
  EXPECT_EQ(static_cast<int>(graph.edges.size()) - static_cast<int>(graph.points.size()) + 1, 16);
}

TEST(GraphInput, ADiagonalThatNothingElseReplacesStays) {
  LineSet lines;
  lines.points = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 0}};
  lines.edges = {{0, 1}, {1, 2}, {2, 3}};
  EXPECT_EQ(graph_from_lines(lines).edges.size(), 3u);
  lines.points[2] = {1, 1, 0};  // a triangle whose three edges were timed is one
  lines.edges = {{0, 1}, {1, 2}, {0, 2}};
  lines.edge_attributes = {{"time", 1, {1, 2, 3}}};
  EXPECT_EQ(graph_from_lines(lines).edges.size(), 3u);
}

TEST(GraphInput, EndsWithinTheMeetingDistanceMeet) {
  LineSet lines;
  lines.points = {{0, 0, 0}, {100, 0, 0}, {100, 0.9 * meeting_distance * 100, 0}, {100, 50, 0}};
  lines.edges = {{0, 1}, {2, 3}};
  EXPECT_EQ(graph_from_lines(lines).points.size(), 3u);
  lines.points[2].y() = 2 * meeting_distance * 112;
  EXPECT_EQ(graph_from_lines(lines).points.size(), 4u);
}

TEST(GraphInput, LinesInSpaceNeedNormals) {
  LineSet lines;
  lines.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
  lines.edges = {{0, 1}, {1, 2}, {2, 3}};
  EXPECT_THROW(graph_from_lines(lines), Error);
  lines.point_attributes.push_back({"normal", 3, {0, 0, 1, 0, 0, 1, 1, 1, 1, 1, 0, 0}});
  EXPECT_EQ(graph_from_lines(lines).edges.size(), 3u);
}

TEST(GraphInput, ASmallCellBetweenOpenCracksDoesNotSetTheScale) {
  // Combs of spacing 1 that close nothing, and one tiny triangle.
  LineSet lines;
  const auto add = [&](const Vec3& a, const Vec3& b) {
    const auto n = static_cast<std::int32_t>(lines.points.size());
    lines.points.insert(lines.points.end(), {a, b});
    lines.edges.push_back({n, n + 1});
  };
  for (int i = 0; i < 10; ++i) {
    add({i + 0.0, 0, 0}, {i + 1.0, 0, 0});
    add({i + 0.0, 0, 0}, {i + 0.0, 8, 0});
  }
  add({4.3, 4, 0}, {4.4, 4, 0});
  add({4.4, 4, 0}, {4.3, 4.1, 0});
  add({4.3, 4.1, 0}, {4.3, 4, 0});
  const CrackGraphInput graph = graph_from_lines(lines);
  const StatisticsOptions o;
  const Pattern pattern(graph, o);
  EXPECT_GT(pattern.unit, 1);
  EXPECT_LT(pattern.unit, 2.5);
}

TEST(GraphInput, AFewOrNoLinesAreNoError) {
  const Statistics none = compute_statistics(CrackGraphInput{});
  EXPECT_EQ(none.junctions, 0);
  EXPECT_TRUE(std::isnan(none.area_cv.value));
  LineSet one;
  one.points = {{0, 0, 0}, {1, 1, 0}};
  one.edges = {{0, 1}};
  const Statistics s = compute_statistics(graph_from_lines(one));
  EXPECT_NEAR(s.crack_length, std::sqrt(2.0), 1e-12);
  EXPECT_EQ(s.cells_found, 0);
}

}  // namespace
}  // namespace craze
