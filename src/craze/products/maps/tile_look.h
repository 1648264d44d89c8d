// What a material makes of a tile.
#pragma once

#include "craze/engine/tile.h"
#include "craze/products/maps/material_maps.h"
#include "craze/recipe.h"

namespace craze {

/// Of the recipe's picture.material.
TileMaterial tile_material(const Recipe& recipe);

/// The grooves of a tile: as its recipe says, or as wide and deep as suits the material.
PostParameters tile_grooves(const CrackedTile& tile);

}  // namespace craze
