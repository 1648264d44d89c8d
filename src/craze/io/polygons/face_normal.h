// Normals of triangles of any size.
#pragma once

#include "craze/surface_mesh.h"

namespace craze {

/// The unit normal of triangle f; zero where it has no area or its edges overflow.
inline Vec3 face_normal(const SurfaceMesh& mesh, std::size_t f) {
  const Triangle& t = mesh.triangles[f];
  const Vec3& p = mesh.positions[t[0]];
  const Vec3 a = (mesh.positions[t[1]] - p).stableNormalized();
  const Vec3 b = (mesh.positions[t[2]] - p).stableNormalized();
  const Vec3 n = a.cross(b).stableNormalized();
  return std::abs(n.squaredNorm() - 1) < 1e-9 ? n : Vec3(0, 0, 0);
}

}  // namespace craze
