// How deep a surface can be made solid before it meets itself from behind.
#pragma once

#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// #V, at most `thickness`: how far below its vertices' faces an inner surface may lie, so that it
/// stays on this side of the middle between them and the faces that look the other way. `outwards`
/// as inner_directions() gives it. Throws Cancelled.
std::vector<double> room_inside(const TriangleMesh& mesh, const std::vector<Vec3>& outwards,
                                double thickness, const Context& context);

}  // namespace craze
