// Numbers by which what is near in space lies near in memory.
#pragma once

#include <vector>

#include "craze/mesh/numbering/numbering.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Vertices along a Hilbert curve through their bounding box, faces by their lowest vertices: it
/// follows from the positions alone where no two are the same, whatever the numbers were.
Numbering spatial_numbering(const std::vector<Vec3>& positions,
                            const std::vector<Triangle>& triangles);

}  // namespace craze
