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

/// Base colour, normal, height, occlusion, roughness, mask and fragment.
const std::vector<MapKind>& texture_maps();

/// Cracks a tile (engine/tile.h) and writes its maps, pictures of it laid side by side and on a
/// sphere, and maps.json, each file whole or not at all. Where the recipe says neither post.gap
/// nor post.gap_width, cracks are as wide as suits its material (docs/textures.md). Throws
/// Error(usage) for a map that tiles have not, what crack_tile() throws, Error(output) and
/// Cancelled.
Report make_texture(const TextureRequest& request, const Context& context);

}  // namespace craze
