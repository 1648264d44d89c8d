// Where in the input the faces of an opened surface lie.
#pragma once

#include "craze/engine.h"
#include "craze/products/opening/opened_surface.h"
#include "craze/surface_origin.h"

namespace craze {

/// Per face of the opened surface, which was made of `result`. Empty where that is not made of the
/// input's own triangles.
SurfaceOrigin opened_origin(const Result& result, const OpenedSurface& opened);

}  // namespace craze
