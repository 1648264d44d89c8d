// Tiles to test with: small, and quick to crack.
#pragma once

#include <cmath>

#include "craze/engine/tile.h"
#include "craze/presets.h"

namespace craze {

/// Mud with smooth lines whose pieces are `spacing` of the side of a tile.
inline Recipe mud_for_tiles(double spacing, std::uint64_t seed) {
  Recipe recipe = read_preset("mud");
  recipe.simulation.layer.spacing = spacing;
  recipe.simulation.seed = seed;
  recipe.post.relative_roughness = 0;
  return recipe;
}

inline CrackedTile mud_tile(double spacing, std::uint64_t seed, const Context& context = {}) {
  return crack_tile(mud_for_tiles(spacing, seed), {1, 0}, context);
}

/// The same with post.roughness, in sides, and points as near to each other as it needs to be seen.
inline CrackedTile rough_mud_tile(double spacing, std::uint64_t seed, double roughness) {
  Recipe recipe = mud_for_tiles(spacing, seed);
  recipe.post.roughness = roughness;
  recipe.post.roughness_step = 0.001;
  return crack_tile(recipe, {1, 0}, {});
}

}  // namespace craze
