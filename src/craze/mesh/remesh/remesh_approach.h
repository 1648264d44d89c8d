// The last step of remeshing: the surface comes within the distance stated.
#pragma once

#include "craze/mesh/remesh/remesh_surface.h"

namespace craze {

/// Splits faces whose middle, or that of an edge, lies too far from the input.
void approach_input(RemeshSurface& s);

}  // namespace craze
