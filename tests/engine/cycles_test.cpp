#include "craze/engine/cycles.h"
#include "craze/model/crack_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/error.h"
#include "craze/mesh/validate.h"
#include "craze/model/screening.h"
#include "craze/presets.h"
#include "craze/products/statistics/statistics.h"
#include "craze/shapes.h"

namespace craze {
namespace {

SimulationSurface layered_plate() {
  return {make_shape("plate?n=40&jitter=0.3")};
}

SimulationParameters mud(std::int64_t cycles) {
  SimulationParameters p = read_preset("mud-mature").simulation;
  p.layer.screening_length = 0.1;
  p.evolution.cycles = cycles;
  return resolve_lengths(p, 1);
}

double t_fraction(const LastCycle& last) {
  const Simulation& s = *last.simulation;
  return compute_statistics(graph_from_network(crack_network(s), s.mesh())).t_fraction.value;
}

TEST(Cycles, TurnJunctionsAwayFromT) {
  const double first = t_fraction(run_cycles(layered_plate(), mud(1), {}, {}));
  const double fifth = t_fraction(run_cycles(layered_plate(), mud(5), {}, {}));
  EXPECT_GT(first, 0.8);
  EXPECT_LT(fifth, first - 0.15);
}

TEST(Cycles, TurnJunctionsAwayFromTOnTheMeanOfFourPlates) {
  double first = 0, fifth = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    SimulationParameters once = mud(1), often = mud(5);
    once.seed = often.seed = seed;
    first += t_fraction(run_cycles(layered_plate(), once, {}, {})) / 4;
    fifth += t_fraction(run_cycles(layered_plate(), often, {}, {})) / 4;
  }
  EXPECT_LT(fifth, first - 0.15);
}

TEST(Cycles, GiveTheSameCracksOnAnyNumberOfThreads) {
  Context one, three;
  one.threads = 1;
  three.threads = 3;
  const CrackNetwork a = crack_network(*run_cycles(layered_plate(), mud(2), {}, one).simulation);
  const CrackNetwork b = crack_network(*run_cycles(layered_plate(), mud(2), {}, three).simulation);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    EXPECT_EQ(a.nodes[i].position, b.nodes[i].position);
  }
}

TEST(Cycles, TellHowFarTheyAreAndStopWhenCancelled) {
  double furthest = 0;
  Context context;
  context.progress = [&](const Progress& p) { furthest = std::max(furthest, p.fraction); };
  context.cancelled = [&] { return furthest > 0.3; };
  const LastCycle last = run_cycles(layered_plate(), mud(3), {}, context);
  EXPECT_EQ(last.reason, StopReason::cancelled);
  EXPECT_DOUBLE_EQ(furthest, 1.0 / 3);
}

TEST(Cycles, CrackCoarserMeshesFirstAndTheSurfaceItselfLast) {
  EXPECT_TRUE(coarser_edges(3).empty());
  EXPECT_EQ(coarser_edges(4).size(), 1U);
  EXPECT_EQ(coarser_edges(25).size(), 2U);
  const SimulationSurface coarse[] = {{make_shape("plate?n=26&jitter=0.3")},
                                      {make_shape("plate?n=20&jitter=0.3")}};
  std::vector<double> faces;
  Context context;
  context.progress = [&](const Progress& p) {
    if (p.phase == "prepare") faces.push_back(static_cast<double>(p.triangles));
  };
  const LastCycle last = run_cycles(layered_plate(), mud(9), {}, context, {}, coarse);
  EXPECT_EQ(last.coarser, 0U);
  EXPECT_EQ(last.simulation->mesh().source_face(0), 0);
  const std::vector<double> wanted = {800, 1352, 1352, 1352, 1352, 1352, 3200, 3200, 3200};
  EXPECT_EQ(faces, wanted);
}

TEST(Cycles, StoppedEarlySayWhatTheyCracked) {
  const SimulationSurface coarse[] = {{make_shape("plate?n=20&jitter=0.3")}};
  double furthest = 0;
  Context context;
  context.progress = [&](const Progress& p) { furthest = std::max(furthest, p.fraction); };
  context.cancelled = [&] { return furthest > 0; };
  const LastCycle last = run_cycles(layered_plate(), mud(6), {}, context, {}, coarse);
  EXPECT_EQ(last.reason, StopReason::cancelled);
  EXPECT_EQ(last.coarser, 1U);
  EXPECT_EQ(coarseness(last, mud(6)), 1.5);
}

TEST(Cycles, StoppedEarlyLeaveAWholeSurfaceOfEitherKind) {
  Recipe recipe = read_preset("mud-mature");
  recipe.simulation.layer.relative_spacing = 0.2;
  recipe.simulation.evolution.cycles = 9;
  const auto cup = std::make_shared<const SurfaceMesh>(make_shape("cup?n=24"));
  for (const OutputMesh output : {OutputMesh::asset, OutputMesh::simulation}) {
    recipe.mesh.output = output;
    const auto triangles = [&](double stop_at) {
      // A cycle that has begun has no crack yet.
      bool stops = false;
      Context context;
      context.progress = [&](const Progress& p) {
        stops = stops || (p.phase == "crack" && p.fraction > stop_at && p.cracks > 0);
      };
      context.cancelled = [&] { return stops; };
      const Result result = crack({cup, {}, "cup"}, recipe, {{}, OnCancel::keep}, context);
      EXPECT_GT(result.report().cracks.length, 0);
      EXPECT_TRUE(validate(result.state().mesh()).empty());
      EXPECT_EQ(result.report().carried.lost_pieces, 0);
      return result.report().simulation.triangles;
    };
    const std::int64_t early = triangles(0.1), whole = triangles(1);
    EXPECT_LT(early, 0.6 * static_cast<double>(whole));
  }
}

TEST(Cycles, NeedALayerThatSticks) {
  SimulationParameters p = mud(2);
  p.layer = {};
  EXPECT_THROW(run_cycles(layered_plate(), p, {}, {}), Error);
}

}  // namespace
}  // namespace craze
