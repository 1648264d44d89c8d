// Places that come under load one after the other: the invariants of OnsetLoading, and runs by it.
#include "craze/model/relaxation/onset_loading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "craze/model/crack_network.h"
#include "craze/model/sources/correlated_noise.h"
#include "error_message.h"
#include "model/runs.h"

namespace craze {
namespace {

using test::mesh_of;

constexpr double never = std::numeric_limits<double>::infinity();

/// A layer that sticks, quasistatic, whose cracks do not see the mesh.
SimulationParameters strong_layer() {
  SimulationParameters p;
  p.material.criterion = Criterion::strength;
  p.material.relative_toughness = 0.3;
  p.layer.screening_length = 0.12;
  p.evolution.max_load = 2;
  return p;
}

double middle_x(const TriangleMesh& mesh, std::int32_t f) {
  const Triangle& t = mesh.triangle(f);
  return (mesh.position(t[0]).x() + mesh.position(t[1]).x() + mesh.position(t[2]).x()) / 3;
}

/// Noisy tension whose onset is a function of x.
template <class Onset>
SimulationFields staggered(const TriangleMesh& mesh, Onset onset) {
  SimulationFields fields = test::noisy_tension(mesh, 1);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f)
    fields.onset.push_back(onset(middle_x(mesh, f)));
  return fields;
}

InitialLoad initial_load(const TriangleMesh& mesh, std::vector<double> onset,
                         double failure_load = 1) {
  InitialLoad initial;
  initial.onset = std::move(onset);
  initial.stress = test::random_stress(mesh, 1);
  initial.failure_load = failure_load;
  return initial;
}

std::vector<double> random_onset(const TriangleMesh& mesh) {
  Random random(7);
  std::vector<double> onset(mesh.face_count());
  for (double& o : onset) o = random.uniform(0, 3);
  onset[0] = never;
  return onset;
}

TEST(OnsetLoading, AtEveryStepEachPlaceBearsItsStressTimesTheLoadOfItsOwn) {
  const TriangleMesh mesh = mesh_of("sphere?n=4");
  const InitialLoad initial = initial_load(mesh, random_onset(mesh));
  EvolutionParameters e;
  e.max_load = 2.5;
  e.place_load = 1.2;
  OnsetLoading loading(e, initial);
  StressField field(mesh, test::no_cap);
  while (loading.advance(never, true)) {
    StressField before = field;
    std::vector<double> named(mesh.vertex_count(), 0);
    loading.bring_up(field, mesh, [&](std::int32_t v, double force) { named[v] += force; });
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      const double own = std::clamp(loading.time() - initial.onset[f], 0.0, 1.2);
      const Mat3 should = own * initial.stress[f].matrix();
      ASSERT_LT((field.stress(mesh, f).matrix() - should).norm(), 1e-12 * (1 + should.norm()));
    }
    StressField fresh = field;
    fresh.update_forces(mesh);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      ASSERT_LT((field.force(v) - fresh.force(v)).norm(), 1e-12);
      ASSERT_LE((field.force(v) - before.force(v)).norm(), named[v] * (1 + 1e-9) + 1e-12);
    }
  }
  EXPECT_EQ(loading.time(), 2.5);
}

TEST(OnsetLoading, RisesByNoMoreThanAStepAndJumpsToTheNextPlaceWhereNoneIsOnItsWay) {
  const TriangleMesh mesh = mesh_of("plate?n=2");
  std::vector<double> onset(mesh.face_count(), 0.5);
  onset[1] = 1000;
  EvolutionParameters e;
  e.max_load = 1e4;
  e.place_load = 1;
  OnsetLoading loading(e, initial_load(mesh, onset));
  EXPECT_EQ(loading.step(), e.load_step);
  int steps = 0;
  double last = 0;
  for (; loading.advance(never, true); ++steps) {
    EXPECT_GT(loading.time(), last);
    const double from = last < 0.5 ? 0.5 : last >= 1.5 && last < 1000 ? 1000 : last;
    EXPECT_LE(loading.time(), from + loading.step() * (1 + 1e-9));
    last = loading.time();
  }
  EXPECT_EQ(last, 1001);
  EXPECT_LE(steps, 2 * 50 + 4);
}

TEST(OnsetLoading, ChangesAPlaceNoOftenerThanItTakesToLoadItHoweverFarAFrontRuns) {
  const TriangleMesh mesh = mesh_of("strip?n=4");
  std::vector<double> onset(mesh.face_count());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) onset[f] = f;
  EvolutionParameters e;
  e.max_load = 1e4;
  e.place_load = 1;
  OnsetLoading loading(e, initial_load(mesh, onset));
  StressField field(mesh, test::no_cap);
  std::int64_t changes = 0;
  while (loading.advance(never, true)) {
    loading.bring_up(field, mesh, [&](std::int32_t, double) { ++changes; });
  }
  EXPECT_LE(changes, 3 * mesh.face_count() * (1 / loading.step() + 2));
}

TEST(OnsetLoading, RefusesWhatWouldTakeHoursInOneLine) {
  const TriangleMesh mesh = mesh_of("plate?n=2");
  std::vector<double> onset(mesh.face_count(), 0);
  onset[1] = 1;
  EvolutionParameters e;
  e.max_load = 1e9;
  const std::string message =
      error_of([&] { OnsetLoading(e, initial_load(mesh, onset)); }, ErrorKind::request);
  EXPECT_NE(message.find("evolution.max_load"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(AnOnset, ThatIsTheSameEverywhereMovesAllDatesByItAndChangesNothingElse) {
  constexpr double onset = 0.75;
  const TriangleMesh mesh = mesh_of("plate?n=24&jitter=0.3");
  SimulationParameters p = strong_layer(), later = p;
  later.evolution.max_load += onset;
  Simulation a(mesh, test::noisy_tension(mesh, 1), p, {}),
      b(mesh, staggered(mesh, [&](double) { return onset; }), later, {});
  EXPECT_EQ(a.run({}), b.run({}));
  ASSERT_GT(a.events(), 10);
  EXPECT_EQ(a.mesh().triangles(), b.mesh().triangles());
  EXPECT_EQ(a.mesh().positions(), b.mesh().positions());
  ASSERT_EQ(a.segments(), b.segments());
  for (std::size_t i = 0; i < a.opened().size(); ++i) {
    EXPECT_EQ(b.opened()[i].time, a.opened()[i].time + onset);
  }
  EXPECT_NEAR(b.load(), a.load() + onset, 1e-12);
}

TEST(AnOnset, ThatHardlyDiffersOpensTheFirstCrackWithinAStepOfTheOneWithout) {
  const TriangleMesh mesh = mesh_of("plate?n=24&jitter=0.3");
  SimulationParameters p = strong_layer();
  p.evolution.max_cracks = 1;
  Simulation exact(mesh, test::noisy_tension(mesh, 1), p, {}),
      stepped(mesh, staggered(mesh, [](double x) { return 1e-9 * (1 + x); }), p, {});
  exact.run({});
  stepped.run({});
  ASSERT_EQ(exact.events(), 1);
  ASSERT_EQ(stepped.events(), 1);
  EXPECT_GE(stepped.time(), exact.time());
  EXPECT_LE(stepped.time(), exact.time() + 1.1 * p.evolution.load_step);
}

TEST(AnOnset, BeyondMaxLoadLeavesAPlaceWholeButForWhatItsNeighboursPull) {
  const TriangleMesh mesh = mesh_of("plate?n=40&jitter=0.3");
  const SimulationParameters p = strong_layer();
  Simulation s(mesh, staggered(mesh, [](double x) { return x < 0 ? 0 : 2.5; }), p, {});
  EXPECT_EQ(s.run({}), StopReason::max_load);
  EXPECT_GT(s.events(), 10);
  EXPECT_EQ(s.load(), 2);
  for (const CrackNode& node : crack_network(s).nodes) {
    EXPECT_LT(node.position.x(), p.layer.screening_length);
  }
}

TEST(AnOnset, BeyondMaxLoadEverywhereCracksNothing) {
  const TriangleMesh mesh = mesh_of("plate?n=10");
  for (const bool alike : {true, false}) {
    Simulation s(mesh, staggered(mesh, [&](double x) { return alike || x < 0 ? 3 : never; }),
                 strong_layer(), {});
    EXPECT_EQ(s.run({}), StopReason::max_load);
    EXPECT_EQ(s.events(), 0);
    EXPECT_EQ(s.load(), 2);
  }
}

/// A front from the left that crosses the plate while the load grows by 8.
Simulation behind_a_front(const SimulationParameters& p, int threads = 1) {
  const TriangleMesh mesh = mesh_of("plate?n=32&jitter=0.3");
  Context context;
  context.threads = threads;
  return {mesh, staggered(mesh, [](double x) { return 8 * (x + 0.5); }), p, context};
}

SimulationParameters dries() {
  SimulationParameters p = strong_layer();
  p.evolution.max_load = 20;
  p.evolution.place_load = 2;
  return p;
}

TEST(AFront, DatesCracksFromWhereItStartsOnAndNoneBeforeItsPlaceIsLoaded) {
  Simulation s = behind_a_front(dries());
  EXPECT_EQ(s.run({}), StopReason::equilibrium) << "all is loaded before max_load";
  ASSERT_GT(s.events(), 20);
  double sum_x = 0, sum_t = 0, xx = 0, tt = 0, xt = 0, n = 0;
  for (const OpenedSegment& piece : s.opened()) {
    const double x = s.mesh().position(piece.geometry.to_root).x(), t = piece.time;
    EXPECT_GT(t, 8 * (x + 0.5 - dries().layer.screening_length));
    sum_x += x, sum_t += t, xx += x * x, tt += t * t, xt += x * t, ++n;
  }
  const double correlation =
      (xt - sum_x * sum_t / n) / std::sqrt((xx - sum_x * sum_x / n) * (tt - sum_t * sum_t / n));
  EXPECT_GT(correlation, 0.9);
}

TEST(AFront, LeavesTheLayerInEquilibriumUnderTheWholeLoad) {
  Simulation s = behind_a_front(dries());
  s.run({});
  EXPECT_TRUE(s.met_tolerance());
  EXPECT_NEAR(s.load(), 10, 0.3);
  EXPECT_EQ(s.load_on_field(), 1);
}

TEST(AFront, CracksAlikeOnAnyNumberOfThreads) {
  Simulation a = behind_a_front(dries(), 1), b = behind_a_front(dries(), 3);
  Context one, three;
  one.threads = 1;
  three.threads = 3;
  a.run(one);
  b.run(three);
  EXPECT_EQ(a.mesh().positions(), b.mesh().positions());
  EXPECT_EQ(a.mesh().triangles(), b.mesh().triangles());
  EXPECT_EQ(a.crack_times(), b.crack_times());
}

TEST(AFront, GoesOnWhereItWasStoppedAndStopsAtMaxCracks) {
  Simulation whole = behind_a_front(dries());
  whole.run({});
  Simulation halting = behind_a_front(dries());
  int asked = 0;
  Context context;
  context.cancelled = [&] { return ++asked % 40 == 0; };
  int stops = 0;
  StopReason reason = StopReason::cancelled;
  for (; reason == StopReason::cancelled && stops < 10000; ++stops) reason = halting.run(context);
  EXPECT_GT(stops, 1);
  EXPECT_EQ(reason, StopReason::equilibrium);
  EXPECT_EQ(halting.load(), whole.load());
  EXPECT_NEAR(static_cast<double>(halting.segments()) / static_cast<double>(whole.segments()), 1,
              0.1);
  const std::vector<double> times = halting.crack_times();
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  SimulationParameters few = dries();
  few.evolution.max_cracks = 5;
  Simulation s = behind_a_front(few);
  EXPECT_EQ(s.run({}), StopReason::max_cracks);
  EXPECT_EQ(s.events(), 5);
}

/// Σ L cos 2θ / Σ L of an even layer, θ from x: 1 where all cracks run along x, −1 across it.
double along_x(std::uint64_t seed, double front_speed) {
  const TriangleMesh mesh = mesh_of("plate?n=48&jitter=0.3");
  SimulationParameters p = strong_layer();
  p.material.relative_toughness = 0.15;
  p.material.alpha = 0.85;
  p.layer.screening_length = 0.07;
  p.evolution.max_load = front_speed > 0 ? 100 : 1.2;
  p.evolution.place_load = front_speed > 0 ? 0.95 : 0;
  p.crack = {20, 60, NearVertex::slide, 0.2};
  SimulationFields fields;
  const std::vector<double> noise = face_noise(mesh, 0.035, Random(seed, 1), {});
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    fields.stress.push_back(to_world(Sym2::isotropic(1), tangent_frame(mesh, f)));
    fields.toughness_scale.push_back(1 + 0.1 * std::max(-5.0, noise[f]));
    if (front_speed > 0) fields.onset.push_back((0.5 + middle_x(mesh, f)) / front_speed);
  }
  Simulation s(mesh, fields, p, {});
  s.run({});
  double sum = 0, length = 0;
  const CrackNetwork network = crack_network(s);
  for (const CrackEdge& e : network.edges) {
    const Vec3 way = network.nodes[e.b].position - network.nodes[e.a].position;
    sum += (way.x() * way.x() - way.y() * way.y()) / way.norm();
    length += way.norm();
  }
  return sum / length;
}

TEST(AFront, ThatIsNarrowerThanTheScreeningLengthCracksAnEvenLayerInRowsAlongIt) {
  double behind_front = 0, without = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    behind_front += along_x(seed, 0.028) / 3;
    without += along_x(seed, 0) / 3;
  }
  EXPECT_LT(behind_front, -0.2);
  EXPECT_GT(without, -0.15);
}

}  // namespace
}  // namespace craze
