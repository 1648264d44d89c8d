// The Stanford polygon format.
#pragma once

#include <string>
#include <string_view>

#include "craze/mesh/surface_mesh.h"

namespace craze {

/// Reads ascii and binary of either byte order, properties in any order and of any scalar type.
/// Of `vertex`: x y z; nx ny nz and a UV (s t, u v or texture_u texture_v) go to the corners; red
/// green blue alpha (whole numbers 0–255, floats 0–1) to vertex_colors. Of `face`: vertex_indices
/// or vertex_index; texcoord (two numbers a corner); material_index, named by header lines
/// "comment material NAME". Other scalars become attributes of their name; NAME_0 NAME_1 … become
/// one attribute of several components. Other lists and elements are skipped. Throws Error(input).
SurfaceMesh read_ply(std::string_view bytes, const std::string& name);

/// The mesh as binary little-endian PLY in the terms above: doubles, colours as bytes. Vertices
/// whose corners differ in UV or normal are written once for each (see unify_corners).
std::string format_ply(const SurfaceMesh& mesh);

}  // namespace craze
