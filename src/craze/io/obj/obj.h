// Wavefront OBJ.
#pragma once

#include <string>
#include <string_view>

#include "craze/mesh/surface_mesh.h"

namespace craze {

/// Reads `v` (with colours after x y z), `vt`, `vn`, `f` and `usemtl`; anything else is skipped, so
/// are faces of fewer than three corners. Indices may be negative, lines continued by a backslash.
/// Materials are known by name alone: no MTL file is opened. `usemtl (null)` means no material.
/// Throws Error(input) at `name`:LINE.
SurfaceMesh read_obj(std::string_view bytes, const std::string& name);

/// The mesh as OBJ text: every number round-trips, seams keep their own vt and vn, materials become
/// `usemtl`. OBJ has no place for attributes. `objects`: a face attribute, whose values become one
/// object (`o NAME_VALUE`) each, faces in the order of the values; OBJ knows no places of objects,
/// so all share the world's axes.
std::string format_obj(const SurfaceMesh& mesh, const std::string& objects = "");

}  // namespace craze
