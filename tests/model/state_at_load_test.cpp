// What a run hands over is the state at the load that was reached, by either engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/runs.h"

namespace craze {
namespace {

constexpr double screening_length = 1, length = 6;

/// A strip whose middle is weak, pulled along.
SimulationFields weak_in_the_middle(const TriangleMesh& mesh, double tension) {
  SimulationFields fields;
  fields.stress.assign(mesh.face_count(), Sym3{tension, 0, 0, 0, 0, 0});
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    double x = 0;
    for (const std::int32_t v : mesh.triangle(f)) x += mesh.position(v).x() / 3;
    fields.toughness_scale.push_back(std::abs(x) < 0.1 ? 0.4 : 10);
  }
  return fields;
}

Simulation broken_strip(Engine engine, double tension) {
  SimulationParameters p;
  p.engine = engine;
  p.material.criterion = Criterion::strength;
  p.material.strength = 4;
  p.material.relative_toughness = 0.1;
  p.layer.screening_length = screening_length;
  p.evolution.relaxation_steps = 20000;
  p.evolution.residual = 0.002;
  p.crack = {20, 60, NearVertex::slide, 0};
  TriangleMesh mesh = test::mesh_of("strip?length=6&width=0.5&n=10");
  SimulationFields fields = weak_in_the_middle(mesh, tension);
  Simulation s(std::move(mesh), std::move(fields), p, {});
  s.run({});
  return s;
}

/// How far the middles of the strip's two halves have parted where it broke, over their length.
double gap(const Simulation& s) {
  double left = 0, right = 0;
  for (std::int32_t v = 0; v < s.mesh().vertex_count(); ++v) {
    if (std::abs(s.mesh().position(v).x()) > 0.1) continue;
    left = std::min(left, s.displacement(v).x());
    right = std::max(right, s.displacement(v).x());
  }
  return right - left;
}

TEST(StateAtLoad, ASlitGapesAsFarByBothEngines) {
  const Simulation fast = broken_strip(Engine::quasistatic, 1);
  ASSERT_GT(fast.load(), 1.3) << "a factor that is forgotten must be seen";
  const Simulation euler = broken_strip(Engine::euler, fast.load());
  EXPECT_NEAR(gap(euler) / gap(fast), 1, 0.02);
  // Each half is a shear-lag film of its own: u = σ₀ ℓ tanh(L / 4ℓ) at its ends.
  const double exact =
      2 * fast.load() * screening_length * std::tanh(length / (4 * screening_length));
  EXPECT_NEAR(gap(fast) / exact, 1, 0.05);
}

TEST(StateAtLoad, SourcesDisplacementsStressAndForcesBelongTogether) {
  // σ = s σ₀ + B u, F = −Bᵀ A σ and F = κ A u, with s = 1 from the start and the load at the end.
  for (const std::int64_t events : {0, 40}) {
    SimulationParameters p = test::small_run();
    p.engine = Engine::quasistatic;
    p.material.criterion = Criterion::strength;
    p.material.relative_toughness = 0.3;
    p.evolution.max_load = 3;
    p.evolution.residual = 1e-4;
    p.evolution.max_cracks = events;
    const TriangleMesh start = test::mesh_of("plate?n=20&jitter=0.3");
    const SimulationFields fields = test::noisy_tension(start, 3);
    Simulation s(start, fields, p, {});
    if (events > 0) s.run({});
    ASSERT_EQ(s.events(), events);
    const TriangleMesh& mesh = s.mesh();
    const double load = s.load_on_field();
    EXPECT_TRUE(events > 0 ? load == s.load() && load > 1.01 : load == 1);
    StressField rebuilt(mesh, s.field().singular_value_cap());
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      rebuilt.add_stress(mesh, f, load * fields.stress[mesh.source_face(f)]);
    }
    std::vector<Vec4d> displacements;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      const Vec3 u = s.displacement(v);
      displacements.push_back(Vec4d{{u.x(), u.y(), u.z(), 0}});
    }
    test::displace_all(mesh, rebuilt, displacements);
    double largest = 0, difference = 0;
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      const Sym3 sigma = load * s.field().stress(mesh, f);
      largest = std::max(largest, sigma.matrix().norm());
      difference = std::max(difference, (sigma.matrix() - rebuilt.stress(mesh, f).matrix()).norm());
    }
    EXPECT_LT(difference, 1e-6 * largest);
  }
}

}  // namespace
}  // namespace craze
