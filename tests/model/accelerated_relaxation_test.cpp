// engine = "quasistatic" without adhesion: the paper's flow in fewer steps.
#include <gtest/gtest.h>

#include <cmath>

#include "craze/model/basis_matrix.h"
#include "craze/model/crack_network.h"
#include "model/runs.h"
#include "model/states.h"

namespace craze {
namespace {

using test::energy;
using test::field_of;
using test::mesh_of;
using test::random_stress;

EulerRelaxationOptions accelerated(double time_step) {
  return {time_step, 0, 0, true};
}

/// ½ Σ A |σ_a − σ_b|².
double energy_between(const TriangleMesh& mesh, const StressField& a, const StressField& b) {
  double sum = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    sum += 0.5 * mesh.area(f) *
           (a.stress(mesh, f).matrix() - b.stress(mesh, f).matrix()).squaredNorm();
  }
  return sum;
}

TEST(AcceleratedRelaxation, EndsWhereTheEulerStepsEndToOnePercent) {
  for (const std::string shape : {"plate?n=16&jitter=0.3", "sphere?n=8", "torus?n=24"}) {
    const TriangleMesh mesh = mesh_of(shape);
    const StressField start = field_of(mesh, random_stress(mesh, 1), singular_value_cap(mesh));
    for (const std::int64_t steps : {20, 100, 1000}) {
      StressField euler = start, fast = start;
      test::relax(mesh, euler, {0.1, 0, 0}, steps);
      test::relax(mesh, fast, accelerated(0.1), steps);
      const double apart = energy_between(mesh, fast, euler);
      EXPECT_LT(std::sqrt(apart), 0.01 * std::sqrt(energy(mesh, start, 0)))
          << shape << ", " << steps << " steps";
    }
  }
}

TEST(AcceleratedRelaxation, TakesFarFewerUpdates) {
  const TriangleMesh mesh = mesh_of("sphere?n=8");
  const auto updates = [&](bool fast) {
    StressField field = field_of(mesh, random_stress(mesh, 2));
    EulerRelaxation relaxation(mesh, field, {0.1, 0, 0, fast});
    relaxation.run(field, mesh, 1000, 1);
    return static_cast<double>(relaxation.element_updates());
  };
  EXPECT_GT(updates(false) / updates(true), 15);
}

TEST(AcceleratedRelaxation, AtAnyTimeStepEnergyNeverRises) {
  const TriangleMesh mesh = mesh_of("sphere?n=6");
  for (const double time_step : {0.5, 1.0, 30.0, 1e3}) {
    StressField fast = field_of(mesh, random_stress(mesh, 3)), euler = fast;
    const double start = energy(mesh, fast, 0);
    double last = start;
    for (int i = 0; i < 20; ++i) {
      test::relax(mesh, fast, accelerated(time_step), 3);
      const double now = energy(mesh, fast, 0);
      EXPECT_LE(now, last * (1 + 1e-9)) << time_step;
      last = now;
    }
    EXPECT_LT(last, 0.9 * start);
    // Euler steps too long to be stable are split, so they come to rest too.
    test::relax(mesh, euler, {time_step, 0, 0}, 60);
    EXPECT_LE(energy(mesh, euler, 0), 1.01 * last) << time_step;
  }
}

TEST(AcceleratedRelaxation, StaysStableOnSliversWithoutACap) {
  SurfaceMesh s = make_shape("plate?n=16");
  for (Vec3& p : s.positions) {
    if (std::lround((p.y() + 0.5) * 16) == 6) p.y() += 0.99 / 16;
  }
  const TriangleMesh mesh(std::move(s.positions), std::move(s.triangles));
  StressField field = field_of(mesh, random_stress(mesh, 4));
  const double start = energy(mesh, field, 0);
  test::relax(mesh, field, accelerated(0.1), 100);
  EXPECT_LT(energy(mesh, field, 0), start);
}

TEST(AcceleratedRelaxation, HoldsWhatIsHeld) {
  const TriangleMesh mesh = mesh_of("plate?n=10&jitter=0.3");
  std::vector<char> fixed(mesh.vertex_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) fixed[v] = mesh.is_open_vertex(v);
  StressField field = field_of(mesh, random_stress(mesh, 5)), euler = field;
  test::relax(mesh, field, accelerated(0.1), 400, fixed);
  test::relax(mesh, euler, {0.1, 0, 0}, 400, fixed);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (fixed[v]) {
      EXPECT_EQ(field.displacement(v), Vec3::Zero());
    }
  }
  EXPECT_LT(energy_between(mesh, field, euler), 1e-4 * energy(mesh, field, 0));
}

TEST(AcceleratedRelaxation, GivesTheSameBytesOnAnyNumberOfThreads) {
  const TriangleMesh mesh = mesh_of("plate?n=60&jitter=0.3");
  StressField reference = field_of(mesh, random_stress(mesh, 6));
  const StressField start = reference;
  test::relax(mesh, reference, accelerated(0.1), 300);
  for (const int threads : {2, 3, 0}) {
    StressField field = start;
    test::relax(mesh, field, accelerated(0.1), 300, {}, threads);
    EXPECT_TRUE(test::same_bytes(field, reference)) << threads << " threads";
  }
}

SimulationParameters flow(Engine engine, std::int64_t steps) {
  SimulationParameters p = test::small_run();
  p.engine = engine;
  p.layer.screening_length = 0;
  p.material.toughness = 0.04;
  p.evolution.relaxation_steps = steps;
  return p;
}

double crack_length(const Simulation& simulation) {
  double sum = 0;
  const CrackNetwork network = crack_network(simulation);
  for (const CrackEdge& edge : network.edges) {
    sum += (network.nodes[edge.a].position - network.nodes[edge.b].position).norm();
  }
  return sum;
}

TEST(AcceleratedRelaxation, CracksAsMuchAsThePapersSchemeOnAClosedSurface) {
  double lengths[2] = {0, 0};
  for (const std::uint64_t seed : {1, 2, 3}) {
    for (const Engine engine : {Engine::euler, Engine::quasistatic}) {
      Simulation simulation = test::simulation_of("sphere?n=16", flow(engine, 50), seed);
      simulation.run({});
      EXPECT_GT(simulation.events(), 10);
      lengths[engine == Engine::euler ? 0 : 1] += crack_length(simulation);
    }
  }
  EXPECT_NEAR(lengths[1] / lengths[0], 1, 0.1);
}

}  // namespace
}  // namespace craze
