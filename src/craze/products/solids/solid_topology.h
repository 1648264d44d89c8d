// The faces that close fragments: walls and inner surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"
#include "craze/products/solids/shells.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A vertex of an inner surface.
struct SolidBottom {
  std::int32_t vertex;    ///< of the mesh, above it or on the site above it
  std::int32_t from, to;  ///< the vertices between which the rim lies over it; both `vertex`
  double share;           ///< of the way from the one to the other
};

/// What a cut mesh lacks to be closed solids, one per fragment. With the mesh's own faces each
/// fragment is then closed by index: every edge is used once each way. A crack that ends inside a
/// fragment is a slit in it, down to its inner surface.
struct SolidTopology {
  std::vector<SolidBottom> bottoms;  ///< of fragments, then of cores
  std::vector<Triangle> triangles;   ///< vertices of the mesh, then bottoms from #V on
  std::vector<std::int32_t> beside;  ///< #triangles: the face of the mesh above or beside
  std::vector<std::int32_t> core;    ///< of each triangle of cores: of which, from 0
  std::int32_t inner_begin = 0;      ///< triangles from here on are inner surfaces, before: walls
  std::int32_t core_begin = 0;       ///< triangles from here on are cores
  std::int32_t core_bottom = 0;      ///< bottoms from here on are of cores
};

/// With `cores`, the shells of the mesh, what is left inside each closed one is a solid as well:
/// the inner surfaces of its fragments, put together and turned round. May be null.
SolidTopology solid_topology(const TriangleMesh& mesh, const CrackSites& sites,
                             const Shells* cores);

}  // namespace craze
