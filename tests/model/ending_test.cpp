// Runs that would never end, or would end in numbers that are none.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <limits>

#include "craze/error.h"
#include "craze/model/screening.h"
#include "model/runs.h"

namespace craze {
namespace {

constexpr double huge = 1e300, tiny = 1e-300;

/// A run on a small mesh that is given up after a while; false then.
bool ends(const SimulationParameters& p, SimulationFields fields, const TriangleMesh& mesh) {
  const std::clock_t start = std::clock();  // of this process, however busy the machine is
  Context context;
  context.threads = 1;
  context.cancelled = [&] {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC > 120;
  };
  Simulation s(mesh, std::move(fields), p, context);
  const StopReason reason = s.run(context);
  for (std::int32_t v = 0; v < s.mesh().vertex_count(); ++v) {
    EXPECT_TRUE(s.displacement(v).allFinite());
  }
  return reason != StopReason::cancelled;
}

bool ends(const SimulationParameters& p, const std::string& shape = "plate?n=4&jitter=0.3") {
  const TriangleMesh mesh = test::mesh_of(shape);
  return ends(p, test::noisy_tension(mesh, 1), mesh);
}

SimulationParameters without_adhesion() {
  SimulationParameters p = test::small_run();
  p.layer = {};
  return p;
}

TEST(ARun, EndsWithoutARelaxationStep) {
  for (SimulationParameters p : {test::small_run(), without_adhesion()}) {
    p.evolution.relaxation_steps = 0;
    EXPECT_TRUE(ends(p));
    p.evolution.shrinkage = 0.1;
    EXPECT_TRUE(ends(p));
    p.material.toughness = 1e3;  // nothing fails
    p.evolution.shrinkage = 0;
    EXPECT_TRUE(ends(p));
  }
}

TEST(ARun, EndsUnderCurvatureGrowthWithoutShrinkage) {
  for (const double growth : {0.2, -0.2, 0.01}) {
    for (const double toughness : {0.05, 1e3}) {
      SimulationParameters p = without_adhesion();
      p.material.toughness = toughness;
      const TriangleMesh mesh = test::mesh_of("sphere?n=3");
      SimulationFields fields = test::noisy_tension(mesh, 1);
      for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
        fields.growth.push_back(to_world(Sym2::isotropic(growth), tangent_frame(mesh, f)));
      }
      EXPECT_TRUE(ends(p, fields, mesh)) << growth << " " << toughness;
      fields.growth.assign(fields.growth.size(), Sym3{});  // grows by nothing
      EXPECT_TRUE(ends(p, fields, mesh));
    }
  }
}

TEST(ARun, EndsWhereStressIsNeverRelieved) {
  for (const Criterion criterion : {Criterion::force, Criterion::strength}) {
    SimulationParameters p = without_adhesion();
    p.material.criterion = criterion;
    p.material.strength = 0.1;
    p.material.toughness = 1e-9;
    p.crack.snap_angle = p.crack.back_angle = 0;
    const TriangleMesh mesh = test::mesh_of("plate?n=2&jitter=0.3");
    SimulationFields fields = test::noisy_tension(mesh, 1);
    fields.fixed.assign(mesh.vertex_count(), 1);
    EXPECT_TRUE(ends(p, fields, mesh));
    p.layer.screening_length = 0.2;
    p.engine = Engine::quasistatic;
    EXPECT_TRUE(ends(p, fields, mesh));
  }
}

TEST(ARun, EndsUnderAnyLoad) {
  for (const double load : {0.0, 1e3, huge}) {
    SimulationParameters p = test::small_run();
    p.evolution.max_load = load;
    EXPECT_TRUE(ends(p));
    p.evolution.shrinkage = 0.5;
    if (load < huge) {
      EXPECT_TRUE(ends(p));
    }
    p.engine = Engine::quasistatic;
    EXPECT_TRUE(ends(p));
    p.material.criterion = Criterion::strength;
    EXPECT_TRUE(ends(p));
  }
}

TEST(ARun, EndsWhateverTheLengthsOfTips) {
  SimulationParameters p = test::small_run();
  p.engine = Engine::quasistatic;
  p.material.criterion = Criterion::strength;
  p.crack.stride = huge;
  EXPECT_TRUE(ends(p, "sphere?n=3"));
  p.crack.stride = 0;
  for (const double length : {tiny, huge}) {
    p.material.process_zone = length;
    EXPECT_TRUE(ends(p, "sphere?n=3"));
    p.material.lookahead = length;
    EXPECT_TRUE(ends(p, "sphere?n=3"));
    p.material.lookahead = 0;
  }
}

TEST(ARun, IsRefusedWhereItsStepsWouldTakeForEver) {
  SimulationParameters p = test::small_run();
  p.evolution.relaxation_steps = std::int64_t{1} << 53;
  EXPECT_THROW(ends(p), Error);
  p.evolution.relaxation_steps = 1;
  p.evolution.time_step = huge;
  EXPECT_THROW(ends(p), Error);
  p.evolution.time_step = tiny;  // nothing would ever move
  EXPECT_TRUE(ends(p));
  p = test::small_run();
  p.evolution.shrinkage = 0.5;
  p.evolution.max_load = huge;
  EXPECT_THROW(ends(p), Error);
}

TEST(ARun, IsRefusedWithoutToughnessByEveryEngine) {
  for (const Engine engine : {Engine::euler, Engine::quasistatic}) {
    for (const double length : {0.0, 0.12}) {
      SimulationParameters p = test::small_run();
      p.engine = engine;
      p.layer.screening_length = length;
      p.material.toughness = 0;
      EXPECT_THROW(ends(p), Error);
    }
  }
}

TEST(ARun, WithoutAdhesionKeepsTheToughnessThatARelativeOneCannotReplace) {
  SimulationParameters p = without_adhesion();
  p.material.criterion = Criterion::strength;
  p.material.toughness = 0.2;
  p.material.relative_toughness = 0.3;
  EXPECT_EQ(resolve_lengths(p, 1).material.toughness, 0.2);
}

TEST(ARun, IsRefusedWhereNumbersWouldOverflow) {
  for (const Engine engine : {Engine::euler, Engine::quasistatic}) {
    SimulationParameters p = test::small_run();
    p.engine = engine;
    const TriangleMesh mesh = test::mesh_of("plate?n=4");
    for (const double stress : {huge, std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()}) {
      SimulationFields fields = test::noisy_tension(mesh, 1);
      fields.stress[3].xx = stress;
      EXPECT_THROW(ends(p, fields, mesh), Error) << stress;
    }
    p.layer.screening_length = tiny;
    EXPECT_THROW(ends(p), Error);
  }
}

}  // namespace
}  // namespace craze
