// The input's attributes on the mesh that was cut out of it.
#pragma once

#include <array>

#include "craze/mesh/triangle_mesh.h"
#include "craze/surface_mesh.h"
#include "craze/threads.h"

namespace craze {

/// Where a point lies in a triangle: weights of its corners, which sum to 1.
struct TrianglePoint {
  std::array<std::int32_t, 3> corners;  ///< 0 … 2, in the order to sum in
  std::array<double, 3> weights;        ///< of those corners
};

/// The point of triangle f nearest to p, p lying in its plane or close to it. Weights within 10⁻⁹
/// of 0 are 0, so a corner is itself; on an edge the weights and their order depend on the edge
/// alone, so both its triangles find the same value there, to the last bit.
TrianglePoint locate_in_triangle(const SurfaceMesh& surface, std::int32_t f, const Vec3& p);

/// The cut mesh with everything that `surface` has: corner UVs and normals and vertex colours and
/// attributes interpolated (normals to unit length), materials, face attributes and source_faces
/// copied. `cut` was made from the positions and triangles of `surface`. Values at the vertices of
/// `surface` are exact copies; copies of a vertex along a crack have equal values.
SurfaceMesh transfer_attributes(const SurfaceMesh& surface, const TriangleMesh& cut,
                                const Threads& threads = 1);

}  // namespace craze
