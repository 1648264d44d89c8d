// Which way inwards is.
#pragma once

#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// Directions longer than this would put the corners of sharp spikes far off.
constexpr double longest_mitre = 2;

/// #V, away from the inside: a vertex that goes by −d times it comes to lie d below its faces, so
/// that at hard edges it is longer than 1, at most `longest_mitre`. Zero where no face has area.
std::vector<Vec3> inner_directions(const std::vector<Vec3>& positions,
                                   const std::vector<Triangle>& triangles);

}  // namespace craze
