// The Stanford polygon format.
#pragma once

#include <string_view>

#include "craze/io/bytes/byte_sink.h"
#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"
#include "craze/write_mesh.h"

namespace craze {

/// Reads ascii and binary of either byte order, properties in any order and of any scalar type.
/// Of `vertex`: x y z; nx ny nz and a UV (s t, u v, texture_u texture_v and the like) go to the
/// corners; red green blue alpha (r g b a, diffuse_…; whole numbers 0–255, floats 0–1, or 0–255
/// where one exceeds 2) to vertex_colors. Of `face`: vertex_indices or vertex_index; texcoord (two
/// numbers a corner); material_index, named by header lines "comment material NAME". Of
/// `tristrips`: strips that −1 ends. Other scalars become attributes of their name; NAME_0 NAME_1 …
/// become one attribute of several components. Other lists and elements are skipped, and so is what
/// ascii rows hold beyond the header, with a warning. Names of "comment TextureFile NAME" lines are
/// told, and comments kept as the scene. Throws Error(input).
SurfaceMesh read_ply(const MeshSource& source);

/// Whether the first line is "ply".
bool is_ply(std::string_view bytes);

/// The mesh as binary little-endian PLY in the terms above: doubles, colours as bytes. Vertices
/// whose corners differ in UV or normal are written once for each (see unify_corners).
void write_ply(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
               const Context& context);

}  // namespace craze
