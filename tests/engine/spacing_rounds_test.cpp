#include "craze/engine/spacing_rounds.h"

#include <gtest/gtest.h>

#include "craze/mesh/components.h"
#include "craze/presets.h"
#include "craze/shapes.h"

namespace craze {
namespace {

/// A fragment of that size bends around the torus' tube, whose radius is 0.09 of the diagonal.
Recipe coarse_glaze(std::int64_t rounds) {
  Recipe recipe = read_preset("glaze");
  recipe.simulation.layer.relative_spacing = 0.4;
  recipe.simulation.layer.rounds = rounds;
  return recipe;
}

double over_asked(const SpacedRun& run) {
  const TriangleMesh& mesh = run.last.simulation->mesh();
  return mean_spacing(mesh, find_components(mesh).count) / run.recipe.simulation.layer.spacing;
}

TEST(SpacingRounds, BringTheSpacingToWhatWasAskedForWhereTheSurfaceBends) {
  constexpr int seeds = 6;  // a torus of that spacing has four to eight fragments
  double before = 0, after = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Recipe recipe = coarse_glaze(0);
    recipe.simulation.seed = seed;
    const SpacedRun once = run_to_spacing(make_shape("torus?n=40"), recipe, {}, {});
    recipe.simulation.layer.rounds = 4;
    const SpacedRun righted = run_to_spacing(make_shape("torus?n=40"), recipe, {}, {});
    before += over_asked(once) / seeds;
    after += over_asked(righted) / seeds;
    EXPECT_LT(over_asked(once), 0.9) << seed;
    EXPECT_LE(std::abs(over_asked(righted) - 1), std::abs(over_asked(once) - 1)) << seed;
    EXPECT_EQ(once.recipe.simulation.layer.spacing, righted.recipe.simulation.layer.spacing);
    EXPECT_GT(righted.recipe.simulation.layer.screening_length,
              once.recipe.simulation.layer.screening_length);
  }
  EXPECT_LT(before, 0.85);
  EXPECT_NEAR(after, 1, 0.1);
}

// What depends on ℓ follows it, as if it had been given in the recipe.
TEST(SpacingRounds, TheRecipeThatCameOutMakesTheSamePattern) {
  const SpacedRun righted = run_to_spacing(make_shape("torus?n=40"), coarse_glaze(4), {}, {});
  Recipe again = coarse_glaze(0);
  again.simulation.layer.screening_length = righted.recipe.simulation.layer.screening_length;
  const SpacedRun repeated = run_to_spacing(make_shape("torus?n=40"), again, {}, {});
  EXPECT_EQ(repeated.last.simulation->mesh().positions(),
            righted.last.simulation->mesh().positions());
}

TEST(SpacingRounds, AreNoneWhereTheScreeningLengthIsGiven) {
  Recipe recipe = coarse_glaze(4);
  recipe.simulation.layer.screening_length = 1;
  const SpacedRun run = run_to_spacing(make_shape("torus?n=20"), recipe, {}, {});
  EXPECT_EQ(run.recipe.simulation.layer.screening_length, 1);
}

TEST(SpacingRounds, DoNotChaseASpacingThatTheLoadIsTooSmallFor) {
  Recipe recipe = coarse_glaze(3);
  recipe.simulation.evolution.max_load = 0.5;
  const SpacedRun run = run_to_spacing(make_shape("torus?n=20"), recipe, {}, {});
  recipe.simulation.layer.rounds = 0;
  const SpacedRun once = run_to_spacing(make_shape("torus?n=20"), recipe, {}, {});
  EXPECT_EQ(run.last.simulation->events(), 0);
  EXPECT_EQ(run.surface.mesh.triangles.size(), once.surface.mesh.triangles.size());
}

TEST(SpacingRounds, AreNoneWhereTheSpacingIsPainted) {
  Recipe recipe = coarse_glaze(0);
  SurfaceMesh torus = make_shape("torus?n=20");
  torus.vertex_attributes.push_back({"fade", 1, std::vector<double>(torus.positions.size(), 0.5)});
  recipe.simulation.layer.attribute = "fade";
  const double once =
      run_to_spacing(torus, recipe, {}, {}).recipe.simulation.layer.screening_length;
  recipe.simulation.layer.rounds = 4;
  EXPECT_EQ(run_to_spacing(torus, recipe, {}, {}).recipe.simulation.layer.screening_length, once);
}

TEST(SpacingRounds, ARunFarFromTheSpacingAskedForSaysSo) {
  const TriangleMesh plate(make_shape("plate?n=10").positions, make_shape("plate?n=10").triangles);
  LayerParameters layer;
  EXPECT_FALSE(spacing_warning(layer, plate, 100)) << "none was asked for";
  const double side = mean_spacing(plate, 1);
  layer.spacing = side / 10;
  EXPECT_FALSE(spacing_warning(layer, plate, 100));
  EXPECT_FALSE(spacing_warning(layer, plate, 120)) << "off by a tenth";
  EXPECT_TRUE(spacing_warning(layer, plate, 200));
  EXPECT_TRUE(spacing_warning(layer, plate, 50));
  layer.spacing = side / 2;
  EXPECT_FALSE(spacing_warning(layer, plate, 6)) << "as chance has it with so few";
  layer.texture = "fade.png";
  EXPECT_FALSE(spacing_warning(layer, plate, 50));
}

}  // namespace
}  // namespace craze
