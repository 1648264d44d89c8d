#include "craze/job/dataset/scene/whole_cracks.h"

#include <gtest/gtest.h>

namespace craze {
namespace {

/// A flat network: nodes at places, edges with their time, kinds by how many edges meet.
CrackNetwork network(const std::vector<Vec2>& places,
                     const std::vector<std::array<int, 3>>& edges_with_time) {
  CrackNetwork n;
  std::vector<int> degree(places.size(), 0);
  for (const Vec2& p : places) {
    CrackNode node;
    node.position = {p.x(), p.y(), 0};
    node.normal = Vec3::UnitZ();
    n.nodes.push_back(node);
  }
  for (const auto& [a, b, time] : edges_with_time) {
    CrackEdge edge;
    edge.a = a;
    edge.b = b;
    edge.time = edge.event = time;
    edge.width = 1;
    n.edges.push_back(edge);
    ++degree[a];
    ++degree[b];
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    n.nodes[i].kind = degree[i] == 1   ? JunctionKind::end
                      : degree[i] == 2 ? JunctionKind::bend
                                       : JunctionKind::junction;
  }
  return n;
}

/// A bar from 0 over 1 to 2, opened first, and a leg from 3 to 1.
CrackNetwork t_junction() {
  return network({{-2, 0}, {0, 0}, {2, 0.2}, {0, 2}}, {{0, 1, 1}, {1, 2, 2}, {3, 1, 5}});
}

TEST(WholeCracks, ALegEndsOnTheBarThatRunsOn) {
  const auto cracks = whole_cracks(t_junction());
  ASSERT_EQ(cracks.size(), 2u);
  EXPECT_EQ(cracks[0].edges.size(), 2u);
  EXPECT_EQ(cracks[0].order, 1);
  EXPECT_EQ(cracks[0].time, 1);
  EXPECT_EQ(cracks[0].parent, -1);
  EXPECT_EQ(cracks[1].edges.size(), 1u);
  EXPECT_EQ(cracks[1].order, 2);
  EXPECT_EQ(cracks[1].parent, 0);
}

TEST(WholeCracks, EveryEdgeIsInOneAndNodesAreInOrder) {
  const CrackNetwork n =
      network({{0, 0}, {1, 0}, {2, 0}, {1, 1}, {1, -1}, {3, 1}, {3, -1}},
              {{0, 1, 1}, {1, 2, 1}, {3, 1, 2}, {1, 4, 2}, {2, 5, 3}, {2, 6, 4}});
  std::vector<int> count(n.edges.size(), 0);
  for (const WholeCrack& crack : whole_cracks(n)) {
    ASSERT_EQ(crack.nodes.size(), crack.edges.size() + 1);
    for (std::size_t i = 0; i < crack.edges.size(); ++i) {
      const CrackEdge& e = n.edges[crack.edges[i]];
      ++count[crack.edges[i]];
      EXPECT_EQ(std::minmax(e.a, e.b), std::minmax(crack.nodes[i], crack.nodes[i + 1]));
    }
  }
  EXPECT_EQ(count, std::vector<int>(n.edges.size(), 1));
}

TEST(WholeCracks, AClosedCrackEndsWhereItBegins) {
  const auto cracks = whole_cracks(
      network({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}}));
  ASSERT_EQ(cracks.size(), 1u);
  EXPECT_EQ(cracks[0].edges.size(), 4u);
  EXPECT_EQ(cracks[0].nodes.front(), cracks[0].nodes.back());
}

TEST(WholeCracks, TurnsOfMoreThan45DegreesAreNotRunOnAtJunctions) {
  // Three at 120°: each by itself.
  const double s = std::sqrt(3) / 2;
  const auto cracks = whole_cracks(
      network({{0, 0}, {1, 0}, {-0.5, s}, {-0.5, -s}}, {{0, 1, 1}, {0, 2, 2}, {0, 3, 3}}));
  EXPECT_EQ(cracks.size(), 3u);
}

TEST(JunctionKinds, AreToldByTheirAngles) {
  const double s = std::sqrt(3) / 2;
  EXPECT_EQ(junction_kinds(t_junction()),
            (std::vector<std::string_view>{"end", "t", "end", "end"}));
  EXPECT_EQ(junction_kinds(network({{0, 0}, {1, 0}, {-0.5, s}, {-0.5, -s}},
                                   {{0, 1, 1}, {0, 2, 2}, {0, 3, 3}}))[0],
            "y");
  EXPECT_EQ(junction_kinds(network({{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}},
                                   {{0, 1, 1}, {0, 2, 1}, {0, 3, 2}, {0, 4, 2}}))[0],
            "x");
  EXPECT_EQ(junction_kinds(network({{0, 0}, {1, 0}, {0, 1}, {-1, -0.2}},
                                   {{0, 1, 1}, {0, 2, 1}, {0, 3, 2}}))[0],
            "t");
  EXPECT_EQ(junction_kinds(network({{0, 0}, {1, 0}, {0, 1}, {0.5, -0.9}},
                                   {{0, 1, 1}, {0, 2, 1}, {0, 3, 2}}))[0],
            "other");
}

}  // namespace
}  // namespace craze
