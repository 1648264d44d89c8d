// [[impact]]: from what a recipe says to a point on the surface and a radius.
#pragma once

#include <vector>

#include "craze/base/period.h"
#include "craze/context.h"
#include "craze/parameters.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The impacts by point and radius alone; the surface has triangles. By direction: the first place
/// of the surface on the line that runs in it through the middle of the box; where that line misses
/// the surface, the place nearest to where it enters the box. By UV: the place with it on the
/// first triangle that has one. By point: the place nearest to it. Throws Error(request) where
/// there is no such place, or the nearest is farther from the point than a tenth of the diagonal of
/// the box.
std::vector<Impact> place_impacts(std::vector<Impact> impacts, const SurfaceMesh& surface,
                                  const Context& context, const Period& period = {});

}  // namespace craze
