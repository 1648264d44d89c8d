// Where the vertices of solids lie.
#pragma once

#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"
#include "craze/products/solids/solid_topology.h"

namespace craze {

/// Fragments with a thickness yet to be chosen: below each vertex of a fragment, moved with it,
/// lies one of its inner surface. A core stays where the surface was, far enough below to be clear
/// of what moved.
struct SolidShape {
  const TriangleMesh& mesh;  ///< cut and shut
  const CrackSites& sites;
  const Shells& shells;
  const std::vector<Vec3>& opened;       ///< #V: where its vertices are
  const std::vector<Vec3>& outwards;     ///< #V, the same on a site: inner_directions.h
  const std::vector<double>& clearance;  ///< #V, the same on a site, length: of the core
  /// What the inner surface does not go of the outer one's way, as a share per depth, so that walls
  /// lean as much where a piece is thin; 1/length.
  double wedge;
  const SolidTopology& topology;
  /// #V, or none: how far chips moved the outer surface, which they do no farther than half of the
  /// depth, and not the inner one.
  const std::vector<Vec3>& chipped;

  /// #V: where its vertices are without their chips.
  std::vector<Vec3> whole() const;
  /// Of the mesh, then of the bottoms. `depth` (#V): how thick, the same on a site.
  std::vector<Vec3> positions(const std::vector<double>& depth) const;
};

/// #V, the same on a site: how far vertices have moved.
std::vector<double> largest_moves(const TriangleMesh& mesh, const CrackSites& sites,
                                  const std::vector<Vec3>& opened);

}  // namespace craze
