// The upright lines of the walls of cracks, one below each site.
#pragma once

#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

/// Walls of both sides of a crack go by the same columns.
struct WallColumn {
  Vec3 along = Vec3::Zero();  ///< unit: the way of the crack's line there; zero at its ends
  double to_end = 0;          ///< along the line, to the nearer end, length; on a ring: infinite
};

/// #S. The lines of cracks end at junctions, tips and the border. `window`, length: the way of a
/// line is that between its points so far ahead and behind.
std::vector<WallColumn> wall_columns(const TriangleMesh& mesh, const CrackSites& sites,
                                     double window);

}  // namespace craze
