// Every parameter at the edges of its range, alone and in pairs: a run ends, with numbers that are
// finite and a valid mesh, or is refused in one line.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <string>

#include "craze/base/random.h"
#include "craze/engine/spacing_rounds.h"
#include "craze/error.h"
#include "craze/mesh/validate.h"
#include "craze/shapes.h"
#include "engine/edge_values.h"

namespace craze {
namespace {

using test::edges_of;

/// Cracks a small mesh in some milliseconds.
Recipe small(Engine engine) {
  Recipe recipe;
  recipe.simulation.engine = engine;
  recipe.simulation.material.toughness = 0.05;
  recipe.simulation.layer.screening_length = 0.3;
  recipe.simulation.evolution.relaxation_steps = 5;
  recipe.simulation.impacts.emplace_back();
  recipe.mesh.edge.kind = EdgeLength::Kind::keep;
  return recipe;
}

/// Those that decide how a run goes, not how it is shown.
bool decides(const Parameter& p) {
  return !test::edges_of(p).empty() && p.section() != "post" && p.section() != "picture";
}

bool is_finite(const Simulation& s) {
  for (std::int32_t v = 0; v < s.mesh().vertex_count(); ++v) {
    if (!s.displacement(v).allFinite() || !s.field().force(v).allFinite()) return false;
  }
  return true;
}

/// Runs, and expects an end within `seconds`, far above what a run of this size needs.
void expect_end(const Recipe& recipe, const std::string& what, double seconds = 60) {
  for (const std::string shape : {"plate?n=3&jitter=0.3", "sphere?n=2"}) {
    const std::clock_t start = std::clock();  // of this process, however busy the machine is
    Context context;
    context.threads = 1;
    context.cancelled = [&] {
      return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC > seconds;
    };
    try {
      const SpacedRun run = run_to_spacing(make_shape(shape), recipe, {}, context);
      EXPECT_NE(run.last.reason, StopReason::cancelled) << what << " on " << shape;
      EXPECT_TRUE(is_finite(*run.last.simulation)) << what << " on " << shape;
      EXPECT_TRUE(validate(run.last.simulation->mesh()).empty()) << what << " on " << shape;
    } catch (const Error& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << what;
    } catch (const Cancelled&) {
      ADD_FAILURE() << what << " on " << shape << " takes for ever to start";
    }
  }
}

std::string set_edge(Recipe& recipe, const Parameter& p, const ParameterValue& value) {
  p.set(recipe, 0, value);
  return p.key + " = " + format_value(value) + " ";
}

TEST(EveryRun, EndsWithEachParameterAtTheEdgesOfItsRange) {
  for (const Engine engine : {Engine::euler, Engine::quasistatic}) {
    for (const Parameter& p : parameter_table()) {
      if (!decides(p)) continue;
      for (const ParameterValue& value : edges_of(p)) {
        Recipe recipe = small(engine);
        const std::string what = set_edge(recipe, p, value);
        expect_end(recipe, what + (engine == Engine::euler ? "(euler)" : "(quasistatic)"));
      }
    }
  }
}

TEST(EveryRunAtLength, EndsWithPairsOfParametersAtTheEdgesOfTheirRanges) {
  std::vector<const Parameter*> keys;
  for (const Parameter& p : parameter_table()) {
    if (decides(p)) keys.push_back(&p);
  }
  Random random(7);
  const auto pick = [&](const Parameter& p) {
    const std::vector<ParameterValue> values = edges_of(p);
    return values[random.below(values.size())];
  };
  for (std::size_t a = 0; a < keys.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      Recipe recipe = small(random.below(2) == 0 ? Engine::euler : Engine::quasistatic);
      // Each of many rounds and cycles is a run that has been tried by itself.
      recipe.simulation.evolution.max_cracks = 40;
      const std::string first = set_edge(recipe, *keys[a], pick(*keys[a]));
      const std::string second = set_edge(recipe, *keys[b], pick(*keys[b]));
      recipe.simulation.evolution.cycles =
          std::min<std::int64_t>(recipe.simulation.evolution.cycles, 2);
      recipe.simulation.layer.rounds = std::min<std::int64_t>(recipe.simulation.layer.rounds, 2);
      expect_end(recipe, first + second);
    }
  }
}

}  // namespace
}  // namespace craze
