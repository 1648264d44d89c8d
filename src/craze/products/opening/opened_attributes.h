// Attributes on the mesh whose cracks were opened.
#pragma once

#include <cstddef>
#include <cstdint>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/opening/opening.h"
#include "craze/surface_mesh.h"

namespace craze {

/// `opened` with the attributes of `cut_surface`, which has the faces and vertices of `cut`.
/// A wall takes the face attributes of the face that it hangs from, the UVs of its upper rim, the
/// material "crack_wall", and source_face −1; it is flat. So does an inner surface, which is as
/// smooth as the outer one. Cores are fragments after all others.
SurfaceMesh opened_attributes(const SurfaceMesh& cut_surface, const TriangleMesh& cut,
                              const OpenedMesh& opened);

/// Of a face of `opened` on an inner surface or a core, the halfedge of `cut` that leaves the
/// corner above its own; −1 for other faces, and where there is no corner above.
std::int32_t corner_above(const TriangleMesh& cut, const OpenedMesh& opened, std::size_t face,
                          int corner);

}  // namespace craze
