// Shading normals.
#pragma once

#include <vector>

#include "craze/mesh/surface_mesh.h"
#include "craze/render/color.h"

namespace craze::render {

/// 3 #F, unit: at each corner, the mean of the normals of the faces around that point, weighted by
/// their angles there, leaving out faces that meet this one at more than `crease` degrees. Corners
/// are joined by position, so an open crack or a texture seam leaves no mark in the shading.
std::vector<Vec3f> smooth_normals(const SurfaceMesh& mesh, double crease);

}  // namespace craze::render
