// The convex hull of points, as physics engines take it.
#pragma once

#include <cstddef>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

struct ConvexHull {
  std::vector<Vec3> positions;      ///< some of the points
  std::vector<Triangle> triangles;  ///< closed, looking outwards; empty where all lie in a plane
};

/// Grows from a tetrahedron by the point farthest outside (Barber, Dobkin and Huhdanpaa, "The
/// Quickhull Algorithm for Convex Hulls", 1996), until none is outside by more than rounding or the
/// hull has `most_vertices`, ≥ 4: then it lies inside the true one, as near as so many allow.
/// Engines take 255 at most.
ConvexHull convex_hull(const std::vector<Vec3>& points, std::size_t most_vertices = 64);

}  // namespace craze
