// Normals and tangents at the corners of triangles, as programs that read the mesh make them.
#pragma once

#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// 3 #F, unit. The mesh's own, or where it has none the mean of the face normals around the point,
/// weighted by angle, over the faces that turn less than 40 degrees from the corner's own.
std::vector<Vec3> corner_normals(const SurfaceMesh& surface);

/// Tangents to go with the normals of a map: n = x T + y s (N × T) + z N.
struct CornerTangents {
  std::vector<Vec3> tangent;        ///< 3 #F, unit, at right angles to the normal: along u
  std::vector<std::int8_t> handed;  ///< #F: s, −1 where the UVs are mirrored
};

/// By Mikkelsen's rules (MikkTSpace): along the gradient of u in each face, brought into the plane
/// of the corner's normal and averaged by angle over the faces that share position, normal, UV and
/// s there.
CornerTangents corner_tangents(const SurfaceMesh& surface, const std::vector<Vec3>& normals);

}  // namespace craze
