// Places that formats in single precision keep, far from the origin too.
#pragma once

#include "craze/surface_mesh.h"

namespace craze {

/// Numbers on this grid, and differences of two of them, are exact in single precision as long as
/// they are no larger than the mesh's coordinates.
double float_grid(const SurfaceMesh& mesh);
/// The same for coordinates up to `largest`.
double float_grid(double largest);

Vec3 on_grid(const Vec3& p, double grid);

/// What to take from every vertex so that single precision keeps the mesh: nothing near the origin,
/// else the middle of its box. On a grid so coarse that the difference is exact.
Vec3 far_origin(const SurfaceMesh& mesh);

/// The centroid by area; by vertices where there is none.
Vec3 centroid(const SurfaceMesh& mesh);

}  // namespace craze
