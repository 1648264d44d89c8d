// Cracks of a mesh that comes from a file, where nothing but open edges tells of them.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// The border halfedges, ascending, that lie on others that run the other way: edges that are open
/// although the surface goes on. These are the cracks of a cracked mesh that was written and read
/// again. Where one side was split and the other was not, the parts lie on the whole, within the
/// rounding of single precision.
std::vector<std::int32_t> seam_sides(const TriangleMesh& mesh);

}  // namespace craze
