// Attributes on the mesh whose cracks were opened.
#pragma once

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/opening/opening.h"
#include "craze/surface_mesh.h"

namespace craze {

/// `opened` with the attributes of `cut_surface`, which has the faces and vertices of `cut`.
/// A wall takes the face attributes of the face that it hangs from, the UVs of its upper rim, the
/// material "crack_wall", and source_face −1. Corner normals are kept where `keep_normals`, walls
/// being flat; else they are left out.
SurfaceMesh opened_attributes(const SurfaceMesh& cut_surface, const TriangleMesh& cut,
                              const OpenedMesh& opened, bool keep_normals);

}  // namespace craze
