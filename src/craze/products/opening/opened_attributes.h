// Attributes on the mesh whose cracks were opened.
#pragma once

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/opening/opening.h"
#include "craze/surface_mesh.h"

namespace craze {

/// `opened` with the attributes of `cut_surface`, which has the faces and vertices of `cut`.
/// A wall takes the face attributes of the face that it hangs from, the UVs of its upper rim, the
/// material "crack_wall", and source_face −1; it is flat.
SurfaceMesh opened_attributes(const SurfaceMesh& cut_surface, const TriangleMesh& cut,
                              const OpenedMesh& opened);

}  // namespace craze
