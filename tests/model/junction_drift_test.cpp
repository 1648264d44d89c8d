#include "craze/model/junction_drift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace craze {
namespace {

/// Straight cracks of many pieces from the origin, in directions given in degrees. Node 0 is the
/// junction.
CrackNetwork star(const std::vector<double>& directions, double length) {
  CrackNetwork network;
  network.nodes.push_back({Vec3::Zero(), Vec3::UnitZ(), 0, JunctionKind::junction});
  for (const double degrees : directions) {
    const double a = degrees * std::numbers::pi / 180;
    std::int32_t before = 0;
    for (int i = 1; i <= 30; ++i) {
      const Vec3 p = length * i / 30 * Vec3(std::cos(a), std::sin(a), 0);
      network.nodes.push_back(
          {p, Vec3::UnitZ(), 0, i < 30 ? JunctionKind::bend : JunctionKind::end});
      const auto now = static_cast<std::int32_t>(network.nodes.size() - 1);
      network.edges.push_back({before, now});
      before = now;
    }
  }
  return network;
}

const CrackNode& junction_of(const CrackNetwork& network) {
  for (const CrackNode& node : network.nodes) {
    if (node.kind == JunctionKind::junction) return node;
  }
  return network.nodes.front();
}

/// The largest angle, in degrees, between two of the cracks at the junction, seen over a distance.
double largest_gap(const CrackNetwork& network, double over) {
  const Vec3 middle = junction_of(network).position;
  std::vector<double> angles;
  for (const CrackEdge& e : network.edges) {
    const Vec3 a = network.nodes[e.a].position - middle, b = network.nodes[e.b].position - middle;
    if ((a.norm() < over) == (b.norm() < over)) continue;
    angles.push_back(std::atan2(0.5 * (a + b).y(), 0.5 * (a + b).x()) * 180 / std::numbers::pi);
  }
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 360 - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
  return gap;
}

TEST(JunctionDrift, AStraightCrackAndThreeEqualAnglesStay) {
  for (const auto& directions : {std::vector<double>{0, 180}, {90, 210, 330}}) {
    const CrackNetwork moved = drifted(star(directions, 1), 0.2);
    EXPECT_LT(junction_of(moved).position.norm(), 1e-12);
    EXPECT_NEAR(total_length(moved), static_cast<double>(directions.size()), 1e-9);
  }
}

TEST(JunctionDrift, ATMovesTowardItsLegByAboutTheDistanceAndTurnsIntoAY) {
  const double distance = 0.1;
  const CrackNetwork before = star({0, 180, 270}, 1), after = drifted(before, distance);
  const Vec3 middle = junction_of(after).position;
  EXPECT_LT(middle.y(), -0.3 * distance);
  EXPECT_GT(middle.y(), -distance);
  EXPECT_NEAR(middle.x(), 0, 1e-12);
  EXPECT_NEAR(largest_gap(before, 0.05), 180, 1e-9);
  EXPECT_LT(largest_gap(after, 0.05), 150);
  EXPECT_LT(total_length(after), total_length(before));
}

TEST(JunctionDrift, DoesNotDependOnThePiecesOfTheCracks) {
  CrackNetwork few = star({0, 180, 270}, 1);
  few = drifted(few, 1e-3);  // many more pieces, moved by a thousandth
  const Vec3 a = junction_of(drifted(star({0, 180, 270}, 1), 0.1)).position;
  const Vec3 b = junction_of(drifted(few, 0.1)).position;
  EXPECT_LT((a - b).norm(), 5e-3);
}

TEST(JunctionDrift, EndsStayAndAClosedCrackShrinksTowardItsMiddle) {
  const CrackNetwork moved = drifted(star({0, 100, 200}, 1), 0.2);
  int ends = 0;
  for (const CrackNode& node : moved.nodes) {
    if (node.kind != JunctionKind::end) continue;
    EXPECT_NEAR(node.position.norm(), 1, 1e-12);
    ++ends;
  }
  EXPECT_EQ(ends, 3);

  CrackNetwork ring;
  for (int i = 0; i < 60; ++i) {
    const double a = 2 * std::numbers::pi * i / 60;
    ring.nodes.push_back({Vec3(std::cos(a), std::sin(a), 0), Vec3::UnitZ(), 0, JunctionKind::bend});
    ring.edges.push_back({i, (i + 1) % 60});
  }
  // dR/dt = −1/R: R² = 1 − distance² after the time distance²/2.
  const CrackNetwork shrunk = drifted(ring, 0.4);
  for (const CrackNode& node : shrunk.nodes) {
    EXPECT_NEAR(node.position.norm(), std::sqrt(1 - 0.16), 0.01);
  }
}

}  // namespace
}  // namespace craze
