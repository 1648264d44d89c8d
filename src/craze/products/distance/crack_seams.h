// Cracks of a mesh that comes from a file, told from the seams of its textures and normals.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Of seam_sides(mesh), those that are cracks. Where the surface has the attribute crack_distance,
/// the ones on which it is 0. Elsewhere the ones that nothing but a cut explains: UVs, normals,
/// colours, material and object are the same on both sides. None where most triangles share no edge
/// at all, as in files that repeat every vertex. `mesh` has the surface's triangles.
std::vector<std::int32_t> crack_seams(const SurfaceMesh& surface, const TriangleMesh& mesh);

}  // namespace craze
