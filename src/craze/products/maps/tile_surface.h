// A tile as maps are baked of it.
#pragma once

#include "craze/engine/tile.h"
#include "craze/products/maps/map_surface.h"

namespace craze {

/// The tile in UVs of its own, u = x / side and v = y / side, its border in no place: faces at the
/// border lie half outside 0 … 1, and are drawn on both sides. All places are whole multiples of
/// side / 2⁴⁰, so that where the side is a power of two moving the border changes no number.
MapSurface tile_surface(const CrackedTile& tile);

}  // namespace craze
