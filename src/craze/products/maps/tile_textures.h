// The textures of a tile: maps of its cracks, and what its material makes of them.
#pragma once

#include <vector>

#include "craze/context.h"
#include "craze/engine/tile.h"
#include "craze/maps.h"
#include "craze/products/maps/map_surface.h"
#include "craze/products/maps/material_maps.h"

namespace craze {

/// Base colour, normal, height, occlusion, roughness, mask and fragment.
const std::vector<MapKind>& texture_maps();

/// A cracked tile and all that its maps are made of. Where the recipe says neither post.gap nor
/// post.gap_width, cracks are as wide as suits its material (docs/textures.md).
class TileTextures {
 public:
  /// Throws Error(usage) for what bake() would not take: a size, a map that tiles have not. Worth
  /// asking before a run.
  static void check(const MapOptions& options);

  /// Throws what crack_tile() throws.
  TileTextures(const Recipe& recipe, const TileSize& size, const Context& context);

  TileTextures(const TileTextures&) = delete;
  TileTextures& operator=(const TileTextures&) = delete;

  const CrackedTile& tile() const { return tile_; }
  const PostParameters& grooves() const { return grooves_; }

  /// Bakes options.maps, those of texture_maps() where they are none; options.post and by_material
  /// count nothing. Throws what check() throws, and Cancelled.
  void bake(MapOptions options, MapSink& sink, const Context& context) const;

 private:
  CrackedTile tile_;
  MapSurface surface_;
  PostParameters grooves_;
  TileMaterial material_;
  double stain_width_;
};

}  // namespace craze
