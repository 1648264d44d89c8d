// The paper's claims about its cracks, on small runs over five seeds (docs/claims.md: larger ones).
#include "engine/claims.h"

#include <gtest/gtest.h>

#include "craze/job/figure_table.h"
#include "craze/model/crack_network.h"

namespace craze {
namespace {

constexpr std::uint64_t seeds = 5;

template <class Measure>
double mean_over_seeds(Measure&& measure) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) sum += measure(seed);
  return sum / seeds;
}

Recipe figure_recipe(std::string_view name) {
  return read_recipe(find_figure_recipe(name).text, std::string(name));
}

TEST(Claims, SmallerAlphaGivesMoreTortuousCracks) {
  Recipe recipe = test::coarse_preset("mud", 0.1);
  recipe.simulation.material.relative_lookahead = 0;  // the paper's tips turn by ς alone
  double longer = 1e9, sharper = 1e9;
  for (const double alpha : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    recipe.simulation.material.alpha = alpha;
    double turn = 0;
    const double length = mean_over_seeds([&](std::uint64_t seed) {
      const test::Cracked cracked = test::crack("plate?n=60&jitter=0.3", recipe, seed);
      turn += test::mean_turn(crack_network(cracked.simulation)) / seeds;
      return test::tortuosity(cracked);
    });
    EXPECT_LT(length, longer) << "alpha " << alpha;
    EXPECT_LT(turn, sharper) << "alpha " << alpha;
    longer = length;
    sharper = turn;
  }
}

TEST(Claims, CurvatureScalingAtLeastDoublesTheDensityWhereTheSurfaceIsCurved) {
  const auto contrast = [](const char* name) {
    Recipe recipe = figure_recipe(name);
    recipe.simulation.layer.relative_spacing = 0.08;
    return mean_over_seeds([&](std::uint64_t seed) {
      return test::density_contrast(test::crack("bumps?n=22", recipe, seed));
    });
  };
  EXPECT_GT(contrast("bunny_curvature"), 2);
  EXPECT_NEAR(contrast("bunny_uniform"), 1, 0.15);
}

TEST(Claims, BiasTurnsCracksTowardThePrincipalDirection) {
  Recipe recipe = test::coarse_preset("glaze", 0.09);
  double before = 0;
  for (const double bias : {0.0, 0.5, 1.0}) {
    recipe.simulation.material.bias = bias;
    const double along = mean_over_seeds([&](std::uint64_t seed) {
      return test::alignment(test::crack("drape?n=80", recipe, seed));
    });
    if (bias == 0) {
      EXPECT_NEAR(along, 0, 0.1);
    } else {
      EXPECT_GT(along, before + 0.1) << "bias " << bias;
    }
    before = along;
  }
}

TEST(Claims, CracksMeetFreeBordersAtRightAnglesAndFixedOnesAtAny) {
  const auto off = [](BoundaryKind kind) {
    Recipe recipe = test::coarse_preset("mud", 0.12);
    recipe.simulation.boundary.kind = kind;
    return mean_over_seeds([&](std::uint64_t seed) {
      return test::off_border_normal(test::crack("plate?n=48&jitter=0.3", recipe, seed), 0.06);
    });
  };
  EXPECT_LT(off(BoundaryKind::free), 12);
  EXPECT_GT(off(BoundaryKind::fixed), 22);
}

TEST(Claims, AStruckPlateCracksAlongTheRaysFirst) {
  Recipe recipe = figure_recipe("glass");
  const Vec3 center = recipe.simulation.impacts[0].point;
  const double rings = mean_over_seeds([&](std::uint64_t seed) {
    return test::rings_before_half_the_rays(test::crack("plate?n=40&jitter=0.3", recipe, seed),
                                            center);
  });
  EXPECT_LT(rings, 0.4);
}

TEST(Claims, RelaxationMovesNoNode) {
  for (const Engine engine : {Engine::quasistatic, Engine::euler}) {
    Recipe recipe = test::coarse_preset("mud", 0.2);
    recipe.simulation.engine = engine;
    recipe.simulation.crack.near_vertex =
        NearVertex::snap;  // the other choice moves nodes, by cuts
    recipe.simulation.evolution.shrinkage = 0.003;
    recipe.simulation.evolution.relaxation_steps = 10;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const test::Cracked cracked = test::crack("plate?n=24&jitter=0.3", recipe, seed);
      EXPECT_GT(cracked.simulation.events(), 50);
      EXPECT_EQ(test::farthest_move(cracked), 0);
    }
  }
}

}  // namespace
}  // namespace craze
