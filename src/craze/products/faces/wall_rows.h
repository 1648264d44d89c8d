// Walls in rows: the triangles of walls, divided along their depth.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/products/opening/opening.h"

namespace craze {

/// Triangles of walls that stand between tops, vertices of the mesh, and bottoms.
struct WallRows {
  std::vector<WallPoint> points;     ///< between a top and a bottom, not yet moved aside
  std::vector<std::int32_t> vertex;  ///< of each point: the vertex of the mesh above it
  std::vector<Triangle> triangles;   ///< points come after all vertices of the opened mesh
  std::vector<std::int32_t> parent;  ///< of each triangle: the face of the opened mesh
};

/// Divides the faces begin … end of `opened`, each in the plane that it has, in 2 rows − 1. Both
/// sides of a crack are divided alike. column: of each vertex of the opened mesh, the same for both
/// sides. tops: vertices below are tops.
WallRows wall_rows(const OpenedMesh& opened, std::int32_t begin, std::int32_t end,
                   const std::vector<std::int32_t>& column, std::int32_t tops, int rows);

}  // namespace craze
