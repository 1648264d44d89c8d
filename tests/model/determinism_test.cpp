// Same input, parameters and seed: the same bytes, on any number of threads.
#include <gtest/gtest.h>

#include <cstring>

#include "model/runs.h"

namespace craze {
namespace {

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void expect_same(const Simulation& a, const Simulation& b) {
  EXPECT_TRUE(same_bytes(a.mesh().positions(), b.mesh().positions()));
  EXPECT_TRUE(same_bytes(a.mesh().triangles(), b.mesh().triangles()));
  EXPECT_TRUE(same_bytes(a.field().elements(), b.field().elements()));
  EXPECT_TRUE(same_bytes(a.crack_times(), b.crack_times()));
  ASSERT_EQ(a.mesh().vertex_count(), b.mesh().vertex_count());
  for (std::int32_t v = 0; v < a.mesh().vertex_count(); ++v) {
    ASSERT_EQ(a.field().force(v), b.field().force(v));
    ASSERT_EQ(a.field().displacement(v), b.field().displacement(v));
  }
  EXPECT_EQ(a.load(), b.load());
  EXPECT_EQ(a.events(), b.events());
}

Simulation run(const std::string& shape, const SimulationParameters& p, int threads) {
  Simulation simulation = test::simulation_of(shape, p, 4, threads);
  Context context;
  context.threads = threads;
  simulation.run(context);
  return simulation;
}

TEST(Determinism, TheSameBytesOnAnyNumberOfThreadsAndInRepeatedRuns) {
  SimulationParameters p = test::small_run();
  p.evolution.max_cracks = 150;
  p.material.toughness = 0.01;
  const Simulation reference = run("plate?n=50&jitter=0.3", p, 1);
  EXPECT_EQ(reference.events(), 150);
  for (const int threads : {1, 2, 3, 0}) {
    expect_same(reference, run("plate?n=50&jitter=0.3", p, threads));
  }
}

TEST(Determinism, TheSameBytesWithShrinkageOnAClosedSurface) {
  SimulationParameters p = test::small_run();
  p.evolution.max_cracks = 60;
  p.evolution.shrinkage = 0.001;
  const Simulation reference = run("sphere?n=16", p, 1);
  EXPECT_GT(reference.events(), 0);
  for (const int threads : {2, 3}) expect_same(reference, run("sphere?n=16", p, threads));
}

TEST(Determinism, TheSameBytesWhereManyNodesCrackInAStep) {
  SimulationParameters p = test::layer_run();
  p.material.relative_lookahead = 0.4;
  p.layer.screening_length = 0.06;
  p.crack.stride = 0.2;
  p.evolution.max_load = 3;
  p.evolution.load_step = 0.1;
  const Simulation reference = run("plate?n=60&jitter=0.3", p, 1);
  EXPECT_GT(reference.events(), 300);
  for (const int threads : {2, 3}) expect_same(reference, run("plate?n=60&jitter=0.3", p, threads));
}

TEST(Determinism, AnotherSeedGivesAnotherPattern) {
  const SimulationParameters p = test::small_run();
  Simulation a = test::simulation_of("plate?n=20&jitter=0.3", p, 1);
  Simulation b = test::simulation_of("plate?n=20&jitter=0.3", p, 2);
  a.run({});
  b.run({});
  EXPECT_GT(a.events(), 0);
  EXPECT_FALSE(same_bytes(a.mesh().triangles(), b.mesh().triangles()));
}

}  // namespace
}  // namespace craze
