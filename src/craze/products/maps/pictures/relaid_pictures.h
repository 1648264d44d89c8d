// A material's pictures as they look on the surface, laid out in other UVs.
#pragma once

#include <array>
#include <vector>

#include "craze/base/surface_pictures.h"
#include "craze/context.h"
#include "craze/products/maps/map_surface.h"
#include "craze/products/maps/uv_layout.h"

namespace craze {

/// Where the pictures of a material lie: 3 #F UVs of each, in the order of SurfacePictures; null:
/// in those that they are to lie in.
using OwnUvs = std::array<const std::vector<Vec2>*, 4>;

struct RelaidPictures {
  SurfacePictures pictures;  ///< those of other UVs size × size; normals with their scale in them
  /// How many pixels of a picture come to one texel along each side, on average over the surface;
  /// of the picture of which there are most.
  double pixels_per_texel = 0;
};

/// `own` in the UVs of `maps`, whose pieces are its faces, over `sheet`; what lies there already,
/// and what is empty, stays. Pixels that come to one texel are averaged, colours as light. Normals
/// are turned into the new tangent frame. Texels beside the surface take what follows across the
/// border of the island. The same on any number of threads. Throws Cancelled.
RelaidPictures relaid_pictures(const SurfacePictures& own, const OwnUvs& uvs,
                               const MapSurface& maps, const MapSheet& sheet, int size,
                               const Context& context);

}  // namespace craze
