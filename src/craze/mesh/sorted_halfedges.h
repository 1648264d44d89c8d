// The halfedges of triangles, edge by edge.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// The two vertices of halfedge 3f+i, from corner i to corner i+1 of face f, the lower first.
struct VertexPair {
  std::int32_t low, high;
  bool operator==(const VertexPair& o) const { return low == o.low && high == o.high; }
};
VertexPair vertices_of(const std::vector<Triangle>& triangles, std::int32_t halfedge);

/// All 3 #F halfedges by lower vertex, higher vertex, number: those of one edge follow each other.
/// In time linear in their number, where no vertex has many. Corners are in [0, vertices).
std::vector<std::int32_t> sorted_halfedges(const std::vector<Triangle>& triangles,
                                           std::size_t vertices);

}  // namespace craze
