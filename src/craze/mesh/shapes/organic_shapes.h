// Shapes with curvature that varies from place to place.
#pragma once

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A ball of the radius with a few rounded bumps of different width; 20 frequency² triangles.
SurfaceMesh make_bumps(double radius, int frequency, const Context& context);

/// A cloth that hangs over a round post: smooth above, in folds that deepen downwards, with a flat
/// base. `radius` is the mean one at the base.
SurfaceMesh make_drape(double radius, double height, double edge, const Context& context);

}  // namespace craze
