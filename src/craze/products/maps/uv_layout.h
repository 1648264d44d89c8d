// Which pictures a surface's UVs ask for: texture sets and tiles.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/products/maps/map_surface.h"

namespace craze {

/// A piece as it lies in a picture: its UVs less `offset` are 0 … 1 there.
struct PlacedPiece {
  std::int32_t piece;
  Vec2 offset;
};

/// One picture: a set, or one of its tiles.
struct MapSheet {
  std::string texture_set;
  std::int32_t material = -1;  ///< whose set it is; −1: of several, or of none
  int udim = 0;
  std::vector<PlacedPiece> pieces;
};

struct UvLayout {
  std::vector<MapSheet> sheets;
  std::vector<std::string> warnings;
};

/// Share of texels that rounding makes overlap.
inline constexpr double unseen_overlap = 1e-3;

/// The materials that faces have; −1 alone: there are none.
std::set<std::int32_t> used_materials(const SurfaceMesh& surface);

/// Whether each piece lies in one cell of the grid 0 ≤ u < 10, 0 ≤ v and not all in the first.
bool has_tiles(const MapSurface& maps);

/// The pictures of one material's pieces (−1: of those without), with or without tiles.
std::vector<MapSheet> sheets_of_material(const MapSurface& maps, std::int32_t material, bool tiles);

/// Share of the covered texels that more than one piece asks for; 1 without a look where UVs cover
/// a picture more than 64 times.
double overlap_of(const MapSurface& maps, const std::vector<MapSheet>& sheets);

/// One set for all materials where their UVs lie apart, else one per material. Tiles where each
/// piece lies in one cell of the grid 0 ≤ u < 10, 0 ≤ v and not all in the first; UVs that leave
/// 0 … 1 otherwise repeat, but where they cover the picture more than 64 times. by_material: one
/// set per material whatever lies apart, and no tiles. What MapSurface leaves out is in none. Warns
/// where UVs overlap within a set.
UvLayout uv_layout(const MapSurface& maps, bool by_material, const Context& context);

/// #F, 1: a corner of the face is on the border of an island of the UVs.
std::vector<std::uint8_t> faces_at_uv_border(const SurfaceMesh& surface);

}  // namespace craze
