#include "craze/model/crack_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "model/runs.h"

namespace craze {
namespace {

Simulation finished(const std::string& shape, std::int64_t max_cracks = 0) {
  SimulationParameters p = test::small_run();
  p.evolution.max_cracks = max_cracks;
  Simulation s = test::simulation_of(shape, p);
  s.run({});
  return s;
}

TEST(CrackNetwork, HasTheLengthOfTheOpenedEdges) {
  for (const std::string shape : {"plate?n=16&jitter=0.3", "sphere?n=5"}) {
    const Simulation s = finished(shape);
    double open = 0;
    for (std::int32_t h = 0; h < 3 * s.mesh().face_count(); ++h) {
      if (s.mesh().crack_of(h) < 0) continue;
      open += (s.mesh().position(s.mesh().to(h)) - s.mesh().position(s.mesh().from(h))).norm();
    }
    const CrackNetwork network = crack_network(s);
    double length = 0;
    for (const CrackEdge& e : network.edges) {
      length += (network.nodes[e.b].position - network.nodes[e.a].position).norm();
    }
    EXPECT_GT(length, 0) << shape;
    EXPECT_NEAR(length, 0.5 * open, 1e-9 * open) << shape;  // two sides each
  }
}

TEST(CrackNetwork, EdgesMeetOnlyAtNodesAndNoneIsDoubled) {
  const CrackNetwork network = crack_network(finished("plate?n=20&jitter=0.3"));
  std::set<std::pair<std::int32_t, std::int32_t>> seen;
  for (const CrackEdge& e : network.edges) {
    EXPECT_NE(e.a, e.b);
    EXPECT_TRUE(seen.insert(std::minmax(e.a, e.b)).second);
  }
}

TEST(CrackNetwork, KindsCountTheEdgesThatMeet) {
  const CrackNetwork network = crack_network(finished("plate?n=20&jitter=0.3"));
  std::vector<int> degree(network.nodes.size());
  for (const CrackEdge& e : network.edges) ++degree[e.a], ++degree[e.b];
  std::map<JunctionKind, int> count;
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    const CrackNode& node = network.nodes[n];
    ++count[node.kind];
    const bool on_border =
        std::max(std::abs(node.position.x()), std::abs(node.position.y())) > 0.5 - 1e-12;
    const JunctionKind inside = degree[n] == 1   ? JunctionKind::end
                                : degree[n] == 2 ? JunctionKind::bend
                                                 : JunctionKind::junction;
    EXPECT_EQ(node.kind, on_border ? JunctionKind::border : inside);
    EXPECT_NEAR(node.normal.z(), 1, 1e-12);
  }
  EXPECT_GT(count[JunctionKind::border], 0);
  EXPECT_GT(count[JunctionKind::bend], 0);
}

TEST(CrackNetwork, TimesAndEventsGrowWithTheCracks) {
  const Simulation s = finished("sphere?n=6");
  const CrackNetwork network = crack_network(s);
  std::map<std::int32_t, double> time_of;
  for (const CrackEdge& e : network.edges) {
    EXPECT_GE(e.event, 0);
    EXPECT_LT(e.event, s.events());
    EXPECT_LE(e.time, s.time());
    EXPECT_EQ(time_of.emplace(e.event, e.time).first->second, e.time);
  }
  double last = 0;
  for (const auto& [event, time] : time_of) {
    EXPECT_GE(time, last);
    last = time;
  }
}

TEST(CrackNetwork, NodesAndEdgesLieOnTheInputTrianglesTheyName) {
  const std::string shape = "sphere?n=6";
  const CrackNetwork network = crack_network(finished(shape));
  const TriangleMesh input = test::mesh_of(shape);
  for (const CrackNode& node : network.nodes) {
    const Triangle& t = input.triangle(node.face);
    const Vec3& p = input.position(t[0]);
    const Vec3 d = node.position - p;
    const Mat32 frame = tangent_frame(input, node.face);
    EXPECT_LT((d - frame * (frame.transpose() * d)).norm(), 1e-12);  // in its plane
    EXPECT_GT(node.normal.dot(frame.col(0).cross(frame.col(1))), 0.8);
  }
}

TEST(CrackNetwork, CracksUnderTensionOpen) {
  const CrackNetwork network = crack_network(finished("plate?n=20&jitter=0.3"));
  int open = 0;
  for (const CrackEdge& e : network.edges) open += e.width > 1e-4;
  EXPECT_GT(open, 0.8 * static_cast<double>(network.edges.size()));
}

TEST(CrackNetwork, OfAnUncrackedSurfaceIsEmpty) {
  SimulationParameters p = test::small_run();
  p.material.toughness = 100;
  const CrackNetwork network = crack_network(test::simulation_of("plate?n=4", p));
  EXPECT_TRUE(network.nodes.empty());
  EXPECT_TRUE(network.edges.empty());
}

}  // namespace
}  // namespace craze
