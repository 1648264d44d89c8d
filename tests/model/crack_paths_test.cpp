// How cracks run: what the pattern shows, measured on several seeds.
#include <gtest/gtest.h>

#include <cmath>

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
    for (const double angle : test::border_angles(s.network(), reach, 3 * cell)) {
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
