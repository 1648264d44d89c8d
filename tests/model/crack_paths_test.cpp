// How cracks run: what the pattern shows, measured on several seeds.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/runs.h"

namespace craze {
namespace {

/// Points on a crack from a node of degree one on the border inward, up to `reach` away.
std::vector<Vec3> follow_inward(const CrackNetwork& network, std::int32_t start, double reach) {
  std::vector<Vec3> points{network.nodes[start].position};
  std::int32_t at = start, from = -1;
  while ((network.nodes[at].position - points.front()).norm() < reach) {
    std::int32_t onward = -1;
    int ways = 0;
    for (const CrackEdge& e : network.edges) {
      const std::int32_t other = e.a == at ? e.b : e.b == at ? e.a : -1;
      if (other < 0 || other == from) continue;
      onward = other;
      ++ways;
    }
    if (ways != 1) break;  // a tip, or another crack
    from = at;
    at = onward;
    points.push_back(network.nodes[at].position);
  }
  return points;
}

/// The direction of the line fitted to the points.
Vec3 fitted_direction(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& p : points) scatter += (p - mean) * (p - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Mat3>(scatter).eigenvectors().col(2);
}

TEST(CrackPaths, CracksMeetAFreeBorderAtRightAngles) {
  // The free border is loaded along itself only, so a crack there runs across it. Directions drawn
  // at random would be 45° off on average.
  constexpr double reach = 0.1, cell = 1.0 / 30;
  double off = 0, lean = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SimulationParameters p = test::small_run();
    p.material.toughness = 0.02;
    p.evolution.max_cracks = 120;
    Simulation s =
        test::simulation_of("plate?n=30&jitter=0.4&seed=" + std::to_string(seed), p, seed);
    s.run({});
    const CrackNetwork network = s.network();
    for (std::size_t n = 0; n < network.nodes.size(); ++n) {
      const Vec3& at = network.nodes[n].position;
      if (network.nodes[n].kind != JunctionKind::border) continue;
      if (std::min(std::abs(at.x()), std::abs(at.y())) > 0.5 - 3 * cell) continue;  // a corner
      const std::vector<Vec3> points = follow_inward(network, static_cast<std::int32_t>(n), reach);
      if ((points.back() - at).norm() < 0.7 * reach) continue;
      const Vec3 inward = std::abs(at.x()) > std::abs(at.y()) ? Vec3::UnitX() : Vec3::UnitY();
      const Vec3 direction = fitted_direction(points);
      const double cosine = direction.dot(inward);
      const double sine = direction.cross(inward).z() * (cosine < 0 ? -1 : 1);
      const double angle = std::asin(std::clamp(sine, -1.0, 1.0)) * 180 / std::numbers::pi;
      off += std::abs(angle);
      lean += angle;
      ++count;
    }
  }
  ASSERT_GT(count, 20);
  EXPECT_LT(off / count, 15);
  EXPECT_LT(std::abs(lean / count), 8);
}

/// Crack events that start from one weak node of a plate pulled along x to 0.4 of what the other
/// nodes bear. The stress stays as it is (Δt → 0): only Eq. 8 can drive the tips on.
std::int64_t events_from_a_weak_node(double alpha, std::uint64_t seed) {
  const TriangleMesh mesh = test::mesh_of("plate?n=24&jitter=0.4&seed=" + std::to_string(seed));
  const std::int32_t weak = 12 * 25 + 12;
  SimulationFields fields;
  fields.stress.assign(mesh.face_count(), {1, 0, 0, 0, 0, 0});
  fields.toughness_scale.assign(mesh.face_count(), 1);
  mesh.for_each_outgoing(weak, [&](std::int32_t h) { fields.toughness_scale[h / 3] = 0; });
  fields.fixed.assign(mesh.vertex_count(), 1);
  SimulationParameters p;
  p.material.alpha = alpha;
  p.material.toughness = 1.0 / 24 / 0.4;
  p.evolution.time_step = 1e-12;
  Simulation s(mesh, fields, p, {});
  Context context;
  int polls = 0;
  context.cancelled = [&] { return ++polls > 100; };
  s.run(context);
  return s.events();
}

TEST(CrackPaths, ALargerResidualDrivesATipFurtherEquation8) {
  std::int64_t none = 0, half = 0, full = 0;
  for (std::uint64_t seed = 1; seed <= 7; ++seed) {
    const std::int64_t a = events_from_a_weak_node(0, seed), b = events_from_a_weak_node(0.5, seed),
                       c = events_from_a_weak_node(1, seed);
    EXPECT_LE(a, b);
    EXPECT_LE(b, c);
    none += a, half += b, full += c;
  }
  EXPECT_GT(half, 1.5 * none);
  EXPECT_GT(full, 1.2 * half);
}

}  // namespace
}  // namespace craze
