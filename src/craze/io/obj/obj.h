// Wavefront OBJ.
#pragma once

#include <string>

#include "craze/io/bytes/byte_sink.h"
#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"
#include "craze/write_mesh.h"

namespace craze {

/// Reads `v` (with colours after x y z), `vt`, `vn`, `f`, `usemtl`, `o` and `g` (a group of an
/// object is named "o/g"); anything else is skipped, with a warning, so are faces of fewer than
/// three corners. Indices may be negative, lines continued by a backslash. UVs and normals that
/// faces name and the file never gives are left out, with a warning. The libraries of `mtllib`, if
/// the source brings them, and the pictures of their base colours are kept as the scene; without
/// them materials are known by name alone, with a warning. `usemtl (null)` means no material.
/// Throws Error(input) at NAME:LINE.
SurfaceMesh read_obj(const MeshSource& source);

/// The mesh as OBJ text: every number round-trips, seams keep their own vt and vn, materials become
/// `usemtl`. OBJ has no place for attributes. Objects become one `o
/// NAME_VALUE` each, faces in the order of the values; OBJ knows no places of objects, so all share
/// the world's axes.
void write_obj(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
               const Context& context);

}  // namespace craze
