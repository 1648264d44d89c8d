// How long the edges of a simulation mesh are to be, place by place.
#pragma once

#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// #V: the edge length wanted at each vertex. `target` everywhere if `coarsen`; else at most that,
/// and where the mesh is finer, the edge of an equilateral triangle with the mean area there,
/// smoothed over neighbours and not below an eighth of its mean over the mesh.
std::vector<double> edge_length_field(const TriangleMesh& mesh, double target, bool coarsen);

}  // namespace craze
