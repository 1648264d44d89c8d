#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "craze/mesh/validate.h"
#include "craze/model/failure/failure_criterion.h"
#include "craze/model/relaxation/equilibrium.h"
#include "craze/model/screening.h"
#include "model/runs.h"

namespace craze {
namespace {

double largest_residual(const Simulation& s, double kappa) {
  double largest = 0;
  const StressField& field = s.field();
  for (std::int32_t v = 0; v < s.mesh().vertex_count(); ++v) {
    Vec3 r = field.force(v) - kappa * field.node_areas()[v] * field.displacement(v);
    r -= field.normals()[v].dot(r) * field.normals()[v];
    largest = std::max(largest, r.norm());
  }
  return largest;
}

TEST(Quasistatic, NoForceIsLeftOnAnyNodeAtACrackDecision) {
  for (const double residual : {0.002, 0.01, 0.05}) {
    for (const std::int64_t events : {1, 20, 80}) {
      SimulationParameters p = test::layer_run();
      p.evolution.residual = residual;
      p.evolution.max_cracks = events;
      Simulation s = test::simulation_of("plate?n=24&jitter=0.3", p);
      s.run({});
      ASSERT_EQ(s.events(), events);
      // A node fails at strength times its width, here about 1 / 24, at load 1.
      EXPECT_LT(largest_residual(s, adhesion(p.layer)), residual / 24 / s.load());
    }
  }
}

TEST(Quasistatic, StopsAtTheHighestLoadWhereMoreWouldCrackOn) {
  SimulationParameters p = test::layer_run();
  p.evolution.max_load = 1.5;
  Simulation s = test::simulation_of("plate?n=24&jitter=0.3", p);
  EXPECT_EQ(s.run({}), StopReason::max_load);
  EXPECT_EQ(s.load(), 1.5);
  // Below it nothing fails, and no load would make a layer without stress fail.
  Simulation slack(test::mesh_of("plate?n=12"), {}, p, {});
  EXPECT_EQ(slack.run({}), StopReason::equilibrium);
  EXPECT_EQ(slack.events(), 0);
}

TEST(Quasistatic, TheForceThatIsLeftIsTheStressFieldsOwn) {
  // The forces are updated crack by crack; Eq. 1 from the stresses must give the same.
  SimulationParameters p = test::layer_run();
  Simulation s = test::simulation_of("plate?n=24&jitter=0.3", p);
  s.run({});
  EXPECT_GT(s.events(), 100);
  StressField field = s.field();
  for (std::int32_t v = 0; v < s.mesh().vertex_count(); ++v) {
    const Vec3 updated = field.force(v);
    field.update_force(s.mesh(), v);
    EXPECT_LT((updated - field.force(v)).norm(), 1e-9);
  }
}

TEST(Quasistatic, AStripUnderTensionIsLoadedAsTheShearLagFilm) {
  // σ(x) = σ₀ [1 − cosh(x / ℓ) / cosh(L / 2ℓ)], on a strip of length 8 ℓ.
  const TriangleMesh mesh = test::mesh_of("strip?length=8&width=0.5&n=10");
  SimulationFields fields;
  fields.stress.assign(mesh.face_count(), Sym3{1, 0, 0, 0, 0, 0});
  SimulationParameters p = test::layer_run();
  p.layer.screening_length = 1;
  p.material.strength = 1e6;
  p.evolution.max_load = 1e7;
  p.evolution.max_cracks = 1;
  Simulation s(mesh, fields, p, {});
  // The load at which it breaks tells the tension in the middle.
  s.run({});
  EXPECT_NEAR(1e6 / s.load(), 1 - 1 / std::cosh(4.0), 0.01);
}

TEST(Quasistatic, TheSameBytesOnAnyNumberOfThreads) {
  const SimulationParameters p = test::layer_run();
  const Simulation* first = nullptr;
  std::vector<Simulation> runs;
  runs.reserve(3);
  for (const int threads : {1, 2, 3}) {
    Simulation& s = runs.emplace_back(test::simulation_of("plate?n=24&jitter=0.3", p, 1, threads));
    Context context;
    context.threads = threads;
    s.run(context);
    EXPECT_TRUE(validate(s.mesh()).empty());
    if (first == nullptr) {
      first = &s;
      continue;
    }
    ASSERT_EQ(s.mesh().triangles(), first->mesh().triangles());
    EXPECT_EQ(s.crack_times(), first->crack_times());
    EXPECT_EQ(0, std::memcmp(s.mesh().positions().data(), first->mesh().positions().data(),
                             s.mesh().positions().size() * sizeof(Vec3)));
    for (std::int32_t f = 0; f < s.mesh().face_count(); ++f) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_EQ(s.field().elements()[f].t[c], first->field().elements()[f].t[c]);
      }
    }
  }
}

TEST(Quasistatic, CrackTimesAreTheLoadAndNeverFall) {
  Simulation s = test::simulation_of("plate?n=24&jitter=0.3", test::layer_run());
  s.run({});
  const std::vector<double> times = s.crack_times();
  ASSERT_FALSE(times.empty());
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  EXPECT_GT(times.front(), 0.8);
  EXPECT_LE(times.back(), 2);
}

TEST(Strength, TheMeasureIsTheTensionAcrossThePlaneWhateverTheMesh) {
  for (const char* shape : {"plate?n=10", "plate?n=20&jitter=0.4", "plate?n=7&jitter=0.2"}) {
    const TriangleMesh mesh = test::mesh_of(shape);
    StressField field(mesh, std::numeric_limits<double>::infinity());
    for (std::int32_t f = 0; f < mesh.face_count(); ++f)
      field.add_stress(mesh, f, {3, 0, 0, 0, 0, 0});
    field.update_forces(mesh);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.is_open_vertex(v)) continue;
      const Eigenpair pair = largest_eigenpair(separation_tensor(mesh, field, v).tensor);
      EXPECT_NEAR(pair.value / node_width(mesh, v, pair.vector), 3, 1e-9);
    }
  }
}

TEST(Strength, TheTensionAheadOfANodeIsThatOfTheFieldItRunsThrough) {
  const TriangleMesh mesh = test::mesh_of("plate?n=20&jitter=0.3");
  StressField field(mesh, std::numeric_limits<double>::infinity());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f)
    field.add_stress(mesh, f, {2, 5, 0, 1, 0, 0});
  const Vec3 normal = Vec3(1, 2, 0).normalized();
  const double expected =
      normal.x() * normal.x() * 2 + normal.y() * normal.y() * 5 + 2 * normal.x() * normal.y() * 1;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_open_vertex(v)) continue;
    EXPECT_NEAR(mean_tension_ahead(mesh, field, v, normal, 0.2), expected, 1e-9);
  }
}

TEST(Strength, WhereToughnessIsInfiniteNothingCracks) {
  const TriangleMesh mesh = test::mesh_of("plate?n=24&jitter=0.3");
  SimulationFields fields = test::noisy_tension(mesh, 3);
  fields.toughness_scale.assign(mesh.face_count(), 1);
  const auto forbidden = [&](std::int32_t f) {
    return mesh.position(mesh.triangle(f)[0]).x() < -0.1;
  };
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    if (forbidden(f)) fields.toughness_scale[f] = std::numeric_limits<double>::infinity();
  }
  Simulation s(mesh, fields, test::layer_run(), {});
  s.run({});
  EXPECT_GT(s.events(), 50);
  for (std::int32_t f = 0; f < s.mesh().face_count(); ++f) {
    if (!forbidden(s.mesh().source_face(f))) continue;
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(s.mesh().crack_of(3 * f + c), 0);
    }
  }
}

}  // namespace
}  // namespace craze
