// How the walls of both sides of a crack are divided into triangles.
#pragma once

#include <cstddef>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

/// #sides: a wall stands on its bottom edges, one more than the side has sites inside; over so many
/// of them its triangles fan out from the start of the side, over the others from its end. Both
/// sides of a crack are divided alike, so that their walls do not cross however little they part:
/// they fan out from the same site, or, where one side was split, from the ends of the other,
/// whole one.
std::vector<std::size_t> wall_fans(const TriangleMesh& mesh, const CrackSites& sites);

}  // namespace craze
