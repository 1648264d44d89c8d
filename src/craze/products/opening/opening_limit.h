// How far a surface can open before it passes through itself.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"
#include "craze/products/opening/side_walls.h"

namespace craze {

/// How much of the way each vertex goes (#V, 0 … 1, walls: of their depth), the same on a site.
struct OpeningShares {
  std::vector<double> move, depth;
};

/// A cut mesh with side walls, on its way from shut to open.
struct OpeningMotion {
  const TriangleMesh& mesh;
  const CrackSites& sites;
  const SideWalls& walls;
  const std::vector<Vec3>& shift;  ///< #V: where a vertex goes, from its place

  /// Tops, then bottoms of walls.
  std::vector<Vec3> positions(const OpeningShares& shares) const;
};

struct OpeningLimit {
  OpeningShares shares;        ///< 1 where the surface opens all the way
  std::int32_t limited = 0;    ///< vertices that go less than all the way, or have less of a wall
  double least = 1;            ///< the smallest share
  std::int32_t folded = 0;     ///< faces still turned over, or with an edge that points back
  std::int32_t crossings = 0;  ///< pairs of triangles that still cross and did not before
};

/// Starts with all the way. Where that is too much, with as much of it everywhere as takes nearly
/// all rims no further than a third of the distance between cracks. Then takes back what makes
/// triangles turn over, cross or slide over each other in one plane, first the depth of walls, then
/// the movement; from there shares grow with the distance along the surface, so that openings
/// taper. What crosses in the mesh as it is cannot be mended so and does not count, nor do shells
/// that pass through each other as they are. Throws Cancelled.
OpeningLimit limit_opening(const OpeningMotion& motion, const Context& context);

}  // namespace craze
