// Whole runs whose places start apart: with cycles, rounds, impacts and masks, and by the preset.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/engine/tile.h"
#include "craze/shapes.h"
#include "engine/claims.h"
#include "error_message.h"

namespace craze {
namespace {

Recipe drying(double relative_spacing) {
  Recipe recipe = read_preset("mud");
  recipe.simulation.layer.relative_spacing = relative_spacing;
  EvolutionParameters& e = recipe.simulation.evolution;
  e.place_load = 2;
  e.max_load = 12;
  e.onset_speed = {20, LengthUnit::percent};
  e.onset_direction = {1, 0, 0};
  return recipe;
}

Result run(const Recipe& recipe, const Textures& textures = {}) {
  Input input{std::make_shared<const SurfaceMesh>(make_shape("plate?n=12")), textures, "plate"};
  Context context;
  context.threads = 1;
  return crack(input, recipe, {}, context);
}

TEST(Onset, GoesTogetherWithCyclesRoundsImpactsAndMasks) {
  Recipe cycles = drying(0.15), rounds = drying(0.15), impacts = drying(0.15);
  cycles.simulation.evolution.cycles = 3;
  rounds.simulation.layer.rounds = 2;
  impacts.simulation.impacts.push_back({});
  impacts.simulation.impacts[0].radius = 0.1;
  Recipe masked = drying(0.15);
  masked.simulation.where.texture = "half";
  const GreyImage half{8, 1, {0, 0, 0, 0, 1, 1, 1, 1}};
  for (const Recipe& recipe : {cycles, rounds, impacts, masked}) {
    const Result result = run(recipe, {{"half", half}});
    EXPECT_EQ(result.report().stop_reason, "equilibrium");
    EXPECT_GT(result.report().cracks.events, 10);
    EXPECT_GT(result.report().load, 2) << "the whole way of the front";
    EXPECT_LE(result.report().load, 12);
  }
}

TEST(Onset, ByAPictureLeavesWhatIsWhiteWhole) {
  Recipe recipe = read_preset("mud");
  recipe.simulation.layer.relative_spacing = 0.1;
  recipe.simulation.evolution.onset_texture = "when";
  const Result result = run(recipe, {{"when", {8, 1, {0, 0, 0, 0, 1, 1, 1, 1}}}});
  EXPECT_GT(result.report().cracks.events, 10);
  for (const CrackNode& node : result.state().network.nodes) EXPECT_LT(node.position.x(), 0.15);
}

TEST(Onset, ThatNoPlaceReachesIsSaidInTheReport) {
  Recipe recipe = drying(0.15);
  recipe.simulation.evolution.onset_speed = 0;
  recipe.simulation.evolution.onset_direction = Vec3::Zero();
  recipe.simulation.evolution.onset_texture = "when";
  const Result result = run(recipe, {{"when", {1, 1, {1}}}});
  EXPECT_EQ(result.report().cracks.events, 0);
  ASSERT_FALSE(result.report().warnings.empty());
  EXPECT_NE(result.report().warnings.front().find("evolution.max_load"), std::string::npos);
}

TEST(Onset, OfAFrontIsRefusedByEulerStepsAndOnATile) {
  Recipe euler = drying(0.15);
  euler.simulation.engine = Engine::euler;
  EXPECT_NE(error_of([&] { run(euler); }, ErrorKind::request).find("quasistatic"),
            std::string::npos);
  EXPECT_NE(error_of(
                [] {
                  crack_tile(drying(0.1), {1, 0}, {});
                },
                ErrorKind::request)
                .find("tile"),
            std::string::npos);
}

/// Share of the length of cracks that runs along x rather than across it.
double along_x(const CrackNetwork& network) {
  double sum = 0, length = 0;
  for (const CrackEdge& e : network.edges) {
    const Vec3 way = network.nodes[e.b].position - network.nodes[e.a].position;
    sum += (way.x() * way.x() - way.y() * way.y()) / way.norm();
    length += way.norm();
  }
  return sum / length;
}

TEST(DryingFront, CracksSideBySideAlongItsWayAndEarlierWhereItBegan) {
  Recipe recipe = test::coarse_preset("drying-front", 0.07);
  recipe.simulation.evolution.onset_speed = 0.14;  // of a diagonal of √2
  constexpr int seeds = 3;
  double along = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const test::Cracked cracked = test::crack("plate?n=70&jitter=0.3", recipe, seed);
    const CrackNetwork network = crack_network(cracked.simulation);
    along += along_x(network) / seeds;
    double left = 0, right = 0, lefts = 0, rights = 0;
    for (const CrackEdge& e : network.edges) {
      const bool is_left = network.nodes[e.a].position.x() < 0;
      (is_left ? left : right) += e.time;
      ++(is_left ? lefts : rights);
    }
    EXPECT_GT(right / rights, left / lefts + 2) << "half of the plate is 3.5 loads long";
  }
  EXPECT_GT(along, 0.6);
}

/// Σ L cos 2θ / Σ L on the side of a cylinder, θ from its axis.
double along_axis(const CrackNetwork& network) {
  double sum = 0, length = 0;
  for (const CrackEdge& e : network.edges) {
    const Vec3 way = network.nodes[e.b].position - network.nodes[e.a].position;
    sum += (2 * way.z() * way.z() - way.squaredNorm()) / way.norm();
    length += way.norm();
  }
  return sum / length;
}

TEST(Bark, CracksAlongTheTrunk) {
  Recipe bark = test::coarse_preset("bark", 0.08);
  bark.simulation.stress.curvature_radius = 0.1;
  Recipe even = bark;
  even.simulation.material.bias = 0;
  const auto cracked = [](const Recipe& recipe) {
    return along_axis(crack_network(test::crack("cylinder?n=48&open=1", recipe, 1).simulation));
  };
  const double along = cracked(bark);
  EXPECT_GT(along, 0.25);
  EXPECT_GT(along, cracked(even) + 0.2);
}

}  // namespace
}  // namespace craze
