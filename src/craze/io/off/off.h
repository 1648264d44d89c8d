// The Object File Format of Geomview.
#pragma once

#include <string_view>

#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Reads ascii [ST][C][N]OFF: positions, then normals, colours and UVs as the first word says;
/// colours are 0–1, or 0–255 where one exceeds 1. Colours of faces become the face attributes red,
/// green and blue, 0 … 255. Binary and four-dimensional files are refused. Throws Error(input) at
/// NAME:LINE.
SurfaceMesh read_off(const MeshSource& source);

/// Whether the first word is one of those.
bool is_off(std::string_view bytes);

}  // namespace craze
