// Stereolithography files.
#pragma once

#include <string>
#include <string_view>

#include "craze/mesh/surface_mesh.h"

namespace craze {

/// Reads ascii and binary STL, told apart by whether the size fits the binary header's count (a
/// binary file may well start with "solid"). Corners at equal positions become one vertex, numbered
/// by first appearance. Normals and the attribute bytes are ignored. Throws Error(input).
SurfaceMesh read_stl(std::string_view bytes, const std::string& name);

/// The triangles as binary STL, in single precision; a triangle without area has normal zero.
/// Throws Error(request) where a coordinate is too large for that.
std::string format_stl(const SurfaceMesh& mesh);

}  // namespace craze
