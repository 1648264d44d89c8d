// A tileable set of textures, from a recipe.
#pragma once

#include <string>

#include "craze/context.h"
#include "craze/engine/tile.h"
#include "craze/job/maps/write_maps.h"
#include "craze/recipe.h"
#include "craze/report.h"

namespace craze {

struct TextureRequest {
  Recipe recipe;
  TileSize tile;
  MapsRequest maps;      ///< options.maps: empty: those of texture_maps()
  bool previews = true;  ///< preview_plane.png, preview_sphere.png
};

/// Cracks a tile (engine/tile.h) and writes its maps, pictures of it laid side by side and on a
/// sphere, and maps.json, each file whole or not at all. Throws what TileTextures throw
/// (products/maps/tile_textures.h), Error(output) and Cancelled.
Report make_texture(const TextureRequest& request, const Context& context);

}  // namespace craze
