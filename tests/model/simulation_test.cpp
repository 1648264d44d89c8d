// [IO06] §3.1: the loop, its stopping and its limits.
#include "craze/model/simulation.h"
#include "craze/model/crack_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "craze/error.h"
#include "craze/mesh/validate.h"
#include "model/runs.h"

namespace craze {
namespace {

using test::mesh_of;
using test::simulation_of;
using test::small_run;

/// What holds of every state that a run can be left in.
void expect_consistent(const Simulation& s, const std::string& shape) {
  const std::vector<std::string> faults = validate(s.mesh());
  EXPECT_TRUE(faults.empty()) << faults.front();
  EXPECT_NEAR(s.mesh().total_area() / mesh_of(shape).total_area(), 1, 1e-12);
  EXPECT_EQ(static_cast<std::int64_t>(s.crack_times().size()), s.segments());
  StressField fresh = s.field();
  fresh.update_forces(s.mesh());
  for (std::int32_t v = 0; v < s.mesh().vertex_count(); ++v) {
    ASSERT_LE((s.field().force(v) - fresh.force(v)).norm(), 1e-10);
    ASSERT_TRUE(s.field().displacement(v).allFinite());
  }
  for (std::int32_t f = 0; f < s.mesh().face_count(); ++f) {
    ASSERT_TRUE(s.field().stress(s.mesh(), f).matrix().allFinite());
  }
}

TEST(Simulation, TellsOfEachPieceOfCrackWhenItHasOpened) {
  Simulation s = simulation_of("plate?n=20&jitter=0.3", small_run());
  std::vector<OpenedPiece> told;
  s.run({}, [&](const OpenedPiece& piece) { told.push_back(piece); });
  ASSERT_EQ(static_cast<std::int64_t>(told.size()), s.segments());
  for (std::size_t i = 0; i < told.size(); ++i) {
    const CrackSegment& segment = s.opened()[i].geometry;
    EXPECT_EQ(told[i].number, static_cast<std::int64_t>(i));
    EXPECT_EQ(told[i].from, s.mesh().position(segment.from_root));
    EXPECT_EQ(told[i].to, s.mesh().position(segment.to_root));
  }
}

TEST(Simulation, CracksUntilNothingCanFailAndLeavesNoNodeAboveTheToughness) {
  for (const std::string shape : {"plate?n=20&jitter=0.3", "sphere?n=8", "cylinder?n=30&open=1"}) {
    Simulation s = simulation_of(shape, small_run());
    EXPECT_EQ(s.run({}), StopReason::equilibrium);
    EXPECT_GT(s.events(), 3) << shape;
    expect_consistent(s, shape);
    // Those left above τ could not open: back-cracking (θ₂) forbade it. They are few.
    int above = 0;
    for (std::int32_t v = 0; v < s.mesh().vertex_count(); ++v) {
      above += largest_eigenpair(s.separation(v)).value > small_run().material.toughness;
    }
    EXPECT_LT(above, 0.05 * s.mesh().vertex_count()) << shape;
  }
}

TEST(Simulation, WithStrengthTheUnitOfLengthDoesNotMatterByEulerStepsEither) {
  // A power of two, so that not even rounding differs.
  constexpr double unit = 1.0 / 1048576;
  SimulationParameters p = small_run();
  p.material.criterion = Criterion::strength;
  p.material.strength = 0.8;
  p.material.relative_toughness = 0.3;
  const TriangleMesh large = mesh_of("plate?n=16&jitter=0.3");
  std::vector<Vec3> positions = large.positions();
  for (Vec3& x : positions) x *= unit;
  const TriangleMesh small(std::move(positions), large.triangles());
  SimulationParameters q = p;
  q.layer.screening_length = unit * p.layer.screening_length;
  Simulation a(large, test::noisy_tension(large, 1), p, {}),
      b(small, test::noisy_tension(large, 1), q, {});
  EXPECT_EQ(a.run({}), b.run({}));
  EXPECT_GT(a.events(), 20);
  EXPECT_EQ(a.events(), b.events());
  EXPECT_EQ(a.time(), b.time()) << "they come to rest after the same steps";
  EXPECT_EQ(a.mesh().triangles(), b.mesh().triangles());
}

TEST(Simulation, BelowTheToughnessNothingCracks) {
  SimulationParameters p = small_run();
  p.material.toughness = 1;
  Simulation s = simulation_of("plate?n=12", p);
  EXPECT_EQ(s.run({}), StopReason::equilibrium);
  EXPECT_EQ(s.events(), 0);
  EXPECT_EQ(s.mesh().triangles(), mesh_of("plate?n=12").triangles());
}

TEST(Simulation, ZeroStressCracksNothingAndStopsAtOnce) {
  Simulation s(mesh_of("sphere?n=6"), {}, small_run(), {});
  EXPECT_EQ(s.run({}), StopReason::equilibrium);
  EXPECT_EQ(s.events(), 0);
}

TEST(Simulation, CompressionCracksNothing) {
  const TriangleMesh mesh = mesh_of("sphere?n=6");
  SimulationFields fields = test::noisy_tension(mesh, 1);
  for (Sym3& sigma : fields.stress) sigma = -1 * sigma;
  SimulationParameters p = small_run();
  p.layer.screening_length = 0;
  Simulation s(mesh, fields, p, {});
  s.run({});
  EXPECT_EQ(s.events(), 0);
}

TEST(Simulation, MaxCracksIsReachedExactlyAlsoWhereAStepCracksSeveral) {
  for (const std::int64_t per_step : {1, 4}) {
    SimulationParameters p = small_run();
    p.evolution.max_cracks = 7;
    p.evolution.cracks_per_step = per_step;
    Simulation s = simulation_of("plate?n=20&jitter=0.3", p);
    EXPECT_EQ(s.run({}), StopReason::max_cracks);
    EXPECT_EQ(s.events(), 7);
    expect_consistent(s, "plate?n=20&jitter=0.3");
  }
}

TEST(Simulation, CancellingLeavesAConsistentState) {
  for (const int polls : {0, 1, 17}) {
    Simulation s = simulation_of("sphere?n=8", small_run());
    Context context;
    int polled = 0;
    context.cancelled = [&] { return polled++ >= polls; };
    EXPECT_EQ(s.run(context), StopReason::cancelled);
    EXPECT_LE(s.events(), polls);
    expect_consistent(s, "sphere?n=8");
  }
}

TEST(Simulation, ACancelledRunGoesOnToTheSameEnd) {
  Simulation whole = simulation_of("plate?n=16&jitter=0.3", small_run());
  whole.run({});
  Simulation parts = simulation_of("plate?n=16&jitter=0.3", small_run());
  Context context;
  int polled = 0;
  context.cancelled = [&] { return polled++ == 5; };
  EXPECT_EQ(parts.run(context), StopReason::cancelled);
  parts.run({});
  EXPECT_EQ(parts.mesh().triangles(), whole.mesh().triangles());
  EXPECT_EQ(parts.crack_times(), whole.crack_times());
}

TEST(Simulation, IsHeardWhileItRelaxesAndGoesOnToTheSameEnd) {
  SimulationParameters p = small_run();
  p.evolution.relaxation_steps = 20000;
  p.evolution.max_cracks = 2;
  for (const Engine engine : {Engine::euler, Engine::quasistatic}) {
    p.engine = engine;
    // Without adhesion the steps are Chebyshev's.
    p.layer.screening_length = engine == Engine::euler ? 0.12 : 0;
    Simulation whole = simulation_of("plate?n=40&jitter=0.3", p);
    whole.run({});
    Simulation parts = simulation_of("plate?n=40&jitter=0.3", p);
    Context context;
    context.threads = 1;
    bool asked = false;
    context.cancelled = [&] { return std::exchange(asked, !asked); };
    int runs = 1;
    while (parts.run(context) == StopReason::cancelled) ++runs;
    EXPECT_GT(runs, 1);
    EXPECT_EQ(parts.mesh().triangles(), whole.mesh().triangles());
    EXPECT_TRUE(test::same_bytes(parts.field(), whole.field()));
  }
}

TEST(Simulation, IsHeardWhileItLooksAtTheNodesAndGoesOnWithTheRest) {
  SimulationParameters p = small_run();
  p.evolution.max_cracks = 2;
  constexpr const char* shape =
      "plate?n=140&jitter=0.3";  // more nodes than are looked at in one go
  Simulation whole = simulation_of(shape, p);
  whole.run({});
  Simulation parts = simulation_of(shape, p);
  Context context;
  bool asked = false;
  double looked_at = 0;
  context.cancelled = [&] { return std::exchange(asked, !asked); };
  context.progress = [&](const Progress& r) {
    if (r.phase == "prepare") looked_at = r.fraction;
  };
  EXPECT_EQ(parts.run(context), StopReason::cancelled);
  EXPECT_GT(looked_at, 0);
  EXPECT_LT(looked_at, 1);
  EXPECT_EQ(parts.events(), 0);
  parts.run({});
  EXPECT_EQ(parts.mesh().triangles(), whole.mesh().triangles());
  EXPECT_EQ(parts.crack_times(), whole.crack_times());
}

TEST(Simulation, CancelledBeforeItStartsIsNone) {
  Context context;
  context.cancelled = [] { return true; };
  const TriangleMesh mesh = mesh_of("plate?n=4");
  EXPECT_THROW(Simulation(mesh, test::noisy_tension(mesh, 1), small_run(), context), Cancelled);
}

TEST(Simulation, KeepsNothingOfWhereItWasMovedFrom) {
  const TriangleMesh mesh = mesh_of("sphere?n=4");
  SimulationParameters p = small_run();
  p.evolution.shrinkage = 0.05;
  p.evolution.max_cracks = 20;
  SimulationFields fields = test::noisy_tension(mesh, 1);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    fields.growth.push_back(to_world(Sym2::isotropic(0.1), tangent_frame(mesh, f)));
  }
  Simulation stays(mesh, fields, p, {});
  stays.run({});
  auto source = std::make_unique<Simulation>(mesh, fields, p, Context{});
  Simulation moved(std::move(*source));
  source.reset();
  moved.run({});
  EXPECT_EQ(moved.mesh().triangles(), stays.mesh().triangles());
  EXPECT_TRUE(test::same_bytes(moved.field(), stays.field()));
}

TEST(Simulation, CracksAsManyNodesInAStepAsItsEngineIsToldTo) {
  // Without adhesion "quasistatic" flows too, and takes the same number.
  for (const Engine engine : {Engine::euler, Engine::quasistatic}) {
    for (const std::int64_t most : {1, 3, 40}) {
      SimulationParameters p = small_run();
      p.engine = engine;
      p.layer = {};
      p.material.toughness = 0.005;  // many fail at once
      p.evolution.cracks_per_step = most;
      p.evolution.max_cracks = 120;
      Simulation s = simulation_of("plate?n=16&jitter=0.3", p);
      std::int64_t last = 0, greatest = 0;
      Context context;
      context.progress = [&](const Progress& progress) {
        greatest = std::max(greatest, progress.cracks - last);
        last = progress.cracks;
      };
      s.run(context);
      EXPECT_EQ(greatest, most);
    }
  }
}

TEST(Simulation, ShrinkageRaisesTheLoadUntilTheLimit) {
  SimulationParameters p = small_run();
  p.material.toughness = 0.04;
  p.evolution.shrinkage = 0.01;
  p.evolution.max_load = 1.5;
  Simulation s = simulation_of("plate?n=12&jitter=0.3", p);
  EXPECT_EQ(s.run({}), StopReason::max_load);
  EXPECT_NEAR(s.load(), 1.5, 0.011);
  EXPECT_GT(s.events(), 0);
}

TEST(Simulation, LoadIsTheTensionInTheSurfaceWhateverTheInitialTensorsNormalPart) {
  const TriangleMesh mesh = mesh_of("plate?n=6");
  for (const Sym3& tension : {Sym3{1, 1, 1, 0, 0, 0}, Sym3{1, 1, 0, 0, 0, 0}}) {
    SimulationFields fields;
    fields.stress.assign(mesh.face_count(), tension);
    SimulationParameters p = small_run();
    p.material.toughness = 100;
    p.evolution.shrinkage = 0.5;
    p.evolution.max_load = 1.9;  // reached by the second step
    Simulation s(mesh, fields, p, {});
    s.run({});
    EXPECT_NEAR(s.load(), 2, 1e-9);
    EXPECT_NEAR(s.time(), 2 * p.evolution.time_step * p.evolution.relaxation_steps, 1e-12);
  }
}

TEST(Simulation, AHeldBorderNeverMovesNeitherItsNewNodesNorItsCopies) {
  const TriangleMesh mesh = mesh_of("plate?n=14&jitter=0.3");
  SimulationFields fields = test::noisy_tension(mesh, 3);
  fields.fixed.resize(mesh.vertex_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) fields.fixed[v] = mesh.is_open_vertex(v);
  SimulationParameters p = small_run();
  p.layer.screening_length = 0;  // held at the border alone, as in the paper
  Simulation s(mesh, fields, p, {});
  s.run({});
  EXPECT_GT(s.events(), 5);
  int on_border = 0;
  for (std::int32_t v = 0; v < s.mesh().vertex_count(); ++v) {
    const Vec3& position = s.mesh().position(v);
    if (std::max(std::abs(position.x()), std::abs(position.y())) < 0.5 - 1e-12) continue;
    ++on_border;
    EXPECT_EQ(s.field().displacement(v), Vec3::Zero());
  }
  EXPECT_GE(on_border, 4 * 14);
}

TEST(Simulation, ToughPlacesNeverCrack) {
  const TriangleMesh mesh = mesh_of("plate?n=20&jitter=0.3");
  SimulationFields fields = test::noisy_tension(mesh, 5);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const bool left = mesh.position(mesh.triangle(f)[0]).x() < 0;
    fields.toughness_scale.push_back(left ? std::numeric_limits<double>::infinity() : 1);
  }
  Simulation s(mesh, fields, small_run(), {});
  s.run({});
  EXPECT_GT(s.events(), 3);
  for (const CrackNode& node : crack_network(s).nodes) EXPECT_GT(node.position.x(), -0.1);
}

TEST(Simulation, ScalingTheSeparationTensorConcentratesCracksThere) {
  // [IO06] Figs. 4 and 10.
  const TriangleMesh mesh = mesh_of("plate?n=24&jitter=0.3");
  SimulationFields fields = test::noisy_tension(mesh, 6);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    fields.separation_scale.push_back(mesh.position(mesh.triangle(f)[0]).x() < 0 ? 0.6 : 1.6);
  }
  Simulation s(mesh, fields, small_run(), {});
  s.run({});
  const CrackNetwork network = crack_network(s);
  double left = 0, right = 0;
  for (const CrackEdge& e : network.edges) {
    const Vec3 &a = network.nodes[e.a].position, &b = network.nodes[e.b].position;
    (a.x() + b.x() < 0 ? left : right) += (b - a).norm();
  }
  EXPECT_GT(right, 2 * left);
}

TEST(Simulation, FieldsOfTheWrongSizeAreRefusedByName) {
  const TriangleMesh mesh = mesh_of("plate?n=2");
  SimulationFields fields;
  fields.toughness_scale = {1, 2, 3};
  try {
    Simulation(mesh, fields, small_run(), {});
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::request);
    EXPECT_NE(std::string(e.what()).find("toughness scale"), std::string::npos);
  }
}

TEST(Simulation, AMeshWithoutTrianglesIsAtRest) {
  Simulation s(TriangleMesh{}, {}, small_run(), {});
  EXPECT_EQ(s.run({}), StopReason::equilibrium);
}

}  // namespace
}  // namespace craze
