// Side walls: the faces that fill the gaps of opened cracks.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"
#include "craze/surface_mesh.h"

namespace craze {

struct SideWalls {
  std::vector<Vec3> bottom;          ///< the place of a vertex before opening, `depth` inwards
  std::vector<std::int32_t> vertex;  ///< the vertex above each bottom, one of those on its site
  std::vector<Triangle> triangles;   ///< vertices of the mesh, then the bottoms from #V on
  std::vector<std::int32_t> beside;  ///< for each triangle the face of the mesh that it hangs from
};

/// From each side of a crack down to the bottom of the crack's original line, facing the gap. The
/// walls of both sides meet there, neighbouring walls share their edge, and at a tip the two sides
/// share it too, so the surface closes again. A crack that separates no vertex has no walls. With
/// `along_border` the border of the input gets walls as well, as if the sheet had that thickness.
/// `normals` (#V, unit) point away from the inside.
SideWalls side_walls(const TriangleMesh& mesh, const CrackSites& sites,
                     const std::vector<Vec3>& normals, double depth, bool along_border);

}  // namespace craze
