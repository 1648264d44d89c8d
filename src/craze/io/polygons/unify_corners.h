// From values per corner to values per vertex, for formats that know no corners.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// Which corner values keep two copies of a vertex apart.
struct CornerKinds {
  bool uvs = true;
  bool normals = true;
};

/// A mesh whose vertices each have one UV and one normal. Vertex v of the original stays vertex v
/// and takes the values of its first corner; further copies follow after the last original, by
/// vertex and first corner. Vertices without corners keep their place.
struct UnifiedCorners {
  std::vector<std::int32_t> sources;  ///< per new vertex: the original's index
  std::vector<Triangle> triangles;    ///< of new vertices, in the original's order
  std::vector<Vec2> uvs;              ///< per new vertex; empty where the mesh has none
  std::vector<Vec3> normals;          ///< per new vertex; empty where the mesh has none
};

/// The same with these corner normals, 3 #F, instead of the mesh's.
UnifiedCorners unify_corners(const SurfaceMesh& mesh, const std::vector<Vec3>& normals);

/// Copies a vertex only where its corners differ in one of the `kinds` the mesh has.
UnifiedCorners unify_corners(const SurfaceMesh& mesh, const CornerKinds& kinds = {});

}  // namespace craze
