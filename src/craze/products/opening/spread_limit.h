// Limits at vertices that hold around them as well.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

/// Lowers each limit to the least of its site (`on_site`: the vertices of each), and to what a
/// vertex beside it has and `growth` times the edge over `length`: so that what is limited narrows
/// towards where it has no room, whatever the triangles there. Nothing is limited by what has
/// `most`. From the least limit up (Dijkstra): each vertex is settled once.
void spread_limit(const TriangleMesh& mesh, const CrackSites& sites,
                  const std::vector<std::vector<std::int32_t>>& on_site, double most, double growth,
                  double length, std::vector<double>& limit);

/// The same of limits that were spread, of which these have been lowered since.
void spread_limit_from(const TriangleMesh& mesh, const CrackSites& sites,
                       const std::vector<std::vector<std::int32_t>>& on_site,
                       const std::vector<std::int32_t>& lowered, double growth, double length,
                       std::vector<double>& limit);

}  // namespace craze
