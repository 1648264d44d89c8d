// The steps of remeshing that move vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/remesh/remesh_surface.h"

namespace craze {

/// Moves each free vertex to the centre of its star, within the tangent plane, and back onto the
/// input, after a random displacement of up to `shaken` of the length wanted. All targets are found
/// first, so that they do not depend on threads.
void smooth(RemeshSurface& s, double shaken);

/// Puts the free vertices that smoothing left beside the input back onto it. Returns those that
/// moved.
std::vector<std::int32_t> pull_vertices(RemeshSurface& s);

}  // namespace craze
