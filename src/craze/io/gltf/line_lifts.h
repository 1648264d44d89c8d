// What keeps lines on a surface from being lost in it.
#pragma once

#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// #V: a shift along each vertex's normal that lifts a line a hair off the surface, length.
std::vector<Vec3> line_lifts(const SurfaceMesh& mesh);

}  // namespace craze
