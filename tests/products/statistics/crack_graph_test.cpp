#include "craze/products/statistics/graph/crack_graph.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "craze/products/statistics/measures/cells.h"
#include "craze/products/statistics/measures/flaws.h"
#include "craze/products/statistics/measures/junction_angles.h"
#include "craze/products/statistics/null_models/null_models.h"

namespace craze {
namespace {

/// Lines in the xy plane given by their end points.
CrackGraphInput lines(const std::vector<std::pair<Vec2, Vec2>>& pieces) {
  LineSet set;
  for (const auto& [a, b] : pieces) {
    const auto n = static_cast<std::int32_t>(set.points.size());
    set.points.emplace_back(a.x(), a.y(), 0);
    set.points.emplace_back(b.x(), b.y(), 0);
    set.edges.push_back({n, n + 1});
  }
  return graph_from_lines(set);
}

int alive(const CrackGraph& graph) {
  int count = 0;
  for (std::size_t e = 0; e < graph.edges().size(); ++e)
    count += graph.is_alive(static_cast<int>(e));
  return count;
}

int used_nodes(const CrackGraph& graph) {
  return static_cast<int>(std::count_if(graph.nodes().begin(), graph.nodes().end(),
                                        [](const auto& n) { return !n.darts.empty(); }));
}

/// Faces that are discs: a bridge that goes leaves an island, whose contour is one more face.
std::size_t cell_count(const CrackGraph& graph) {
  return find_cells(graph, all_sector_angles(graph, {0, 1}), 0.1, {}, std::nullopt).size();
}

/// The rotation system, the origins and the polylines must agree.
void expect_consistent(const CrackGraph& graph) {
  std::set<Dart> seen;
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    for (const Dart d : graph.nodes()[n].darts) {
      RC_ASSERT(seen.insert(d).second);
      RC_ASSERT(graph.origin(d) == static_cast<std::int32_t>(n));
      const CrackGraph::Edge edge = graph.directed(d);
      RC_ASSERT(edge.points.size() == edge.segments.size() + 1);
      RC_ASSERT(edge.points.size() == edge.normals.size());
      RC_ASSERT((edge.points[0] - graph.nodes()[n].position).norm() < 1e-12);
      double length = 0;
      for (std::size_t i = 1; i < edge.points.size(); ++i) {
        length += (edge.points[i] - edge.points[i - 1]).norm();
      }
      RC_ASSERT(std::abs(length - edge.length) < 1e-9);
    }
  }
  RC_ASSERT(static_cast<int>(seen.size()) == 2 * alive(graph));
}

TEST(CrackGraph, ChainsBecomeSingleLines) {
  const CrackGraph graph(lines({{{0, 0}, {1, 0}}, {{1, 0}, {2, 1}}, {{3, 1}, {2, 1}}}));
  ASSERT_EQ(graph.nodes().size(), 2u);
  ASSERT_EQ(graph.edges().size(), 1u);
  EXPECT_EQ(graph.edges()[0].points.size(), 4u);
  EXPECT_NEAR(graph.edges()[0].length, 2 + std::sqrt(2.0), 1e-12);
  EXPECT_TRUE(graph.is_tip(0));
}

TEST(CrackGraph, ARingWithoutJunctionIsOneFaceOnEachSide) {
  const CrackGraph graph(
      lines({{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}, {{0, 1}, {0, 0}}}));
  EXPECT_EQ(graph.edges().size(), 1u);
  EXPECT_EQ(graph.trace_faces().size(), 2u);
}

TEST(CrackGraph, PruningTakesTheShorterTwigOfAFork) {
  // A stem from a long bar ends in two twigs. Only the shorter one is a spur of the other's line.
  CrackGraph graph(lines({{{0, 0}, {5, 0}},
                          {{5, 0}, {9, 0}},
                          {{5, 0}, {5, 1}},
                          {{5, 1}, {5.3, 1.3}},
                          {{5, 1}, {4.8, 1.2}}}));
  graph.prune_spurs(0.5);
  EXPECT_EQ(alive(graph), 3);
  double longest_y = 0;
  for (const auto& e : graph.edges()) {
    for (const Vec3& p : e.points) longest_y = std::max(longest_y, p.y());
  }
  EXPECT_DOUBLE_EQ(longest_y, 1.3);
  graph.prune_spurs(2);
  EXPECT_EQ(alive(graph), 1) << "the bar is one line again";
}

TEST(CrackGraph, ContractionTurnsTwoCloseTsIntoAnX) {
  CrackGraph graph(lines({{{0, 0}, {1, 0}},
                          {{1, 0}, {1.01, 0}},
                          {{1.01, 0}, {2, 0}},
                          {{1, 0}, {1, 1}},
                          {{1.01, 0}, {1.01, -1}}}));
  graph.contract_edges(0.05);
  EXPECT_EQ(alive(graph), 4);
  const auto x = std::find_if(graph.nodes().begin(), graph.nodes().end(),
                              [](const auto& n) { return n.darts.size() == 4; });
  ASSERT_NE(x, graph.nodes().end());
  EXPECT_NEAR(x->position.x(), 1.005, 1e-12);
}

RC_GTEST_PROP(CrackGraph, SimplifyingKeepsAConnectedPlanarMap, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000000);
  const double length = *rc::gen::element(0.02, 0.05, 0.1, 0.3);
  const auto model = *rc::gen::element(NullModel::poisson_voronoi, NullModel::stit);
  CrackGraph graph(null_graph(model, 60, seed));
  graph.prune_spurs(length);
  graph.contract_edges(length);
  expect_consistent(graph);
  // Euler: the window's border keeps the graph connected.
  const int faces = static_cast<int>(graph.trace_faces().size());
  RC_ASSERT(used_nodes(graph) - alive(graph) + faces == 2);
}

RC_GTEST_PROP(CrackGraph, RemovingDeadEndsKeepsEveryCell, ()) {
  // Random cracks of a mosaic lose their second half: each leaves a dead end and one cell less.
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000000);
  CrackGraphInput input = null_graph(NullModel::poisson_voronoi, 60, seed);
  const std::size_t count = input.edges.size();
  for (std::size_t k = 0; k < 12; ++k) {
    GraphInputEdge& edge = input.edges[(k * 37 + seed) % count];
    if (edge.border) continue;
    // Shortened to its first half: the other half is gone.
    const Vec3 middle = (input.points[edge.a] + input.points[edge.b]) / 2;
    edge.b = static_cast<std::int32_t>(input.points.size());
    input.points.push_back(middle);
    input.normals.push_back(Vec3::UnitZ());
  }
  CrackGraph graph(input);
  const std::size_t cells = cell_count(graph);
  graph.remove_dead_ends();
  expect_consistent(graph);
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    RC_ASSERT(!graph.is_tip(static_cast<std::int32_t>(n)));
  }
  RC_ASSERT(cell_count(graph) == cells);
}

TEST(Flaws, AreSharesOfTheCrackLength) {
  // A bar of 10 with a spur of 0.2 and a dead end of 1.8, and a speck of 0.1 apart; spacing 1.
  const CrackGraph graph(lines({{{0, 0}, {3, 0}},
                                {{3, 0}, {6, 0}},
                                {{6, 0}, {10, 0}},
                                {{3, 0}, {3, 0.2}},
                                {{6, 0}, {6, 1.8}},
                                {{8, 2}, {8.1, 2}}}));
  std::vector<char> ignored(graph.nodes().size(), 0);
  Flaws flaws = measure_flaws(graph, 1, ignored);
  EXPECT_NEAR(flaws.spurs.value, 0.2 / 12.1, 1e-12);
  EXPECT_NEAR(flaws.micro_cracks.value, 0.1 / 12.1, 1e-12);
  EXPECT_NEAR(flaws.dead_ends.value, (3 + 4 + 0.2 + 1.8 + 0.1) / 12.1, 1e-12);
  for (std::size_t n = 0; n < ignored.size(); ++n) {  // the picture ends at x = 0 and 10
    const double x = graph.nodes()[n].position.x();
    ignored[n] = x == 0 || x == 10;
  }
  flaws = measure_flaws(graph, 1, ignored);
  EXPECT_NEAR(flaws.dead_ends.value, (0.2 + 1.8 + 0.1) / 12.1, 1e-12);
}

}  // namespace
}  // namespace craze
