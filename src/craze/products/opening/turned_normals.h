// Normals of a surface that is bent.
#pragma once

#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// 3 #F, unit: the corner normals of `flat`, turned as the faces that they shade turn when its
/// vertices go to `bent` (#V): around a vertex the corners with one normal are a piece of smooth
/// surface, and turn as the mean of its face normals does, weighted by angle. So what was smooth
/// stays smooth, hard edges stay hard, and where nothing turns each normal is what it was.
std::vector<Vec3> turned_normals(const SurfaceMesh& flat, const std::vector<Vec3>& bent);

}  // namespace craze
