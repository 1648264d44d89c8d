// The edges of a shown surface that lie on its cracks.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/engine.h"
#include "craze/products/opening/opened_surface.h"

namespace craze {

/// Halfedges 3f+i of surface.mesh, from corner i to corner i+1 of face f: one side of each edge
/// that a crack opened.
std::vector<std::int32_t> crack_edges(const Result& result, const OpenedSurface& surface);

}  // namespace craze
