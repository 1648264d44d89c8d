// Pictures of a tile: laid side by side, and on a sphere.
#pragma once

#include "craze/context.h"
#include "craze/maps.h"
#include "craze/material/material.h"
#include "craze/render/image.h"
#include "craze/surface_mesh.h"

namespace craze {

/// 2 × 2 tiles as a plane whose vertices are raised by the height map, one for each texel of it;
/// UVs 0 … 2. `side`: of a tile, model units.
SurfaceMesh tiled_plane(const Map& height, double side);

/// 4 × 2 tiles around a sphere in the same way; at the poles they are drawn together.
SurfaceMesh tiled_sphere(const Map& height, double side);

/// A picture of one of these in the tile's base colour.
render::Image tile_picture(const SurfaceMesh& mesh, const Map& base_color,
                           const render::Material& material, const Context& context);

}  // namespace craze
