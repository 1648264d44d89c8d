// The Object File Format of Geomview.
#pragma once

#include <string>
#include <string_view>

#include "craze/mesh/surface_mesh.h"

namespace craze {

/// Reads ascii [ST][C][N]OFF: positions, then normals, colours and UVs as the first word says;
/// colours are 0–1, or 0–255 where one exceeds 1. Face colours are ignored. Binary and
/// four-dimensional files are refused. Throws Error(input) at `name`:LINE.
SurfaceMesh read_off(std::string_view bytes, const std::string& name);

}  // namespace craze
