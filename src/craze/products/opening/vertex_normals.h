// Normals at vertices, the same for all copies of a vertex.
#pragma once

#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

/// #V, unit: the mean of the face normals around the vertex, weighted by angle, over both sides of
/// a crack. Zero for a vertex whose faces have no area.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh, const CrackSites& sites);

}  // namespace craze
