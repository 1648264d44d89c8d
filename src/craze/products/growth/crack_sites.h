// Both sides of each crack, put together again.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// A site is a point of a crack line as it was before the surface opened there: all vertices that
/// lie on it, on either side, share it. A side may have been split after the cut while the other
/// side was not; such a vertex is a site inside the other side's edge.
struct CrackSites {
  std::vector<std::int32_t> site_of;  ///< #V; −1 away from cracks
  std::vector<std::int32_t> vertex;   ///< #S: one vertex on each site
  std::vector<std::int32_t> sides;    ///< the halfedges that are sides of cracks, ascending
  std::vector<std::int32_t> first;    ///< #sides + 1, offsets into inner
  std::vector<std::int32_t> inner;    ///< sites inside each side, in its direction

  /// The next site on side i after that of its from(), and the last one before that of its to().
  std::int32_t after_from(const TriangleMesh& mesh, std::size_t i) const {
    return first[i] < first[i + 1] ? inner[first[i]] : site_of[mesh.to(sides[i])];
  }
  std::int32_t before_to(const TriangleMesh& mesh, std::size_t i) const {
    return first[i] < first[i + 1] ? inner[first[i + 1] - 1] : site_of[mesh.from(sides[i])];
  }
};

CrackSites crack_sites(const TriangleMesh& mesh);

}  // namespace craze
