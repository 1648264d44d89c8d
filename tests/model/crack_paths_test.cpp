// How cracks run: what the pattern shows, measured on several seeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "craze/model/crack_network.h"
#include "model/border_angles.h"
#include "model/runs.h"

namespace craze {
namespace {

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
    for (const double angle : test::border_angles(crack_network(s), reach, 3 * cell)) {
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

/// Nodes inside a plate where a crack that ended there went on in two directions at once.
int forked_tips(const CrackNetwork& network) {
  std::vector<std::vector<std::int32_t>> events_from(network.nodes.size());
  std::vector<std::vector<std::int32_t>> events_at(network.nodes.size());
  for (const CrackEdge& e : network.edges) {
    events_from[e.a].push_back(e.event);
    for (const std::int32_t n : {e.a, e.b}) events_at[n].push_back(e.event);
  }
  int forked = 0;
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    if (network.nodes[n].position.cwiseAbs().maxCoeff() > 0.499) continue;
    for (const std::int32_t event : events_from[n]) {
      const auto same = std::count(events_from[n].begin(), events_from[n].end(), event);
      const auto earlier = std::count_if(events_at[n].begin(), events_at[n].end(),
                                         [&](std::int32_t other) { return other < event; });
      if (same > 1 && earlier == 1) ++forked;
    }
  }
  return forked;
}

TEST(CrackPaths, ATipThatLooksAheadNeverForksBackward) {
  SimulationParameters p;
  p.engine = Engine::quasistatic;
  p.material.criterion = Criterion::strength;
  p.material.strength = 1;
  p.material.relative_toughness = 0.5;
  p.layer.screening_length = 0.1;
  p.evolution.max_load = 2;
  const TriangleMesh mesh = test::mesh_of("plate?n=40&jitter=0.3");
  SimulationFields fields = test::noisy_tension(mesh, 1);
  Random random(2);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    fields.toughness_scale.push_back(random.uniform(0.3, 1.7));
  }
  const auto forked = [&](double lookahead) {
    p.material.relative_lookahead = lookahead;
    Simulation s(mesh, fields, p, {});
    s.run({});
    EXPECT_GT(s.events(), 100);
    return forked_tips(crack_network(s));
  };
  EXPECT_GT(forked(0), 0);
  EXPECT_GT(forked(0.1), 0) << "less than its own star tells a tip";
  for (const double lookahead : {0.6, 1.0}) EXPECT_EQ(forked(lookahead), 0) << lookahead;
}

}  // namespace
}  // namespace craze
