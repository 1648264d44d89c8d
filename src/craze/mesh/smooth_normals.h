// Shading normals.
#pragma once

#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// 3 #F, unit: at each corner, the mean of the normals of the faces that it is smoothly joined to
/// around its point, weighted by their angles there. Faces that meet at less than `crease` degrees
/// are joined, and what they are joined to, so that a rim that bends round in several steps is
/// round. Corners are joined by place: an open crack or a texture seam leaves no mark.
std::vector<Vec3> smooth_normals(const SurfaceMesh& mesh, double crease);

}  // namespace craze
