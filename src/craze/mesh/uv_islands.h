// The islands that a surface falls into in its texture.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// #F: the island of each triangle, counted from 0 in the order of their first triangles: triangles
/// are of one island where they share an edge and its UVs. −1: an island without area in the
/// texture, so a part that has no UVs although the surface has some. The surface has UVs and suits
/// the constructor of TriangleMesh.
std::vector<std::int32_t> uv_islands(const SurfaceMesh& surface);

}  // namespace craze
