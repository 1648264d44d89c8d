// Whether two triangles cross.
#pragma once

#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// Whether an edge of one goes through the inside of the other, by more than rounding. Triangles
/// that share a corner, by index or by place, cross where the opposite edge of one goes through the
/// other or through its opposite edge; those that share two do not. Touching is no crossing, and
/// neither is lying on each other in one plane, but for parts of one sheet that are turned the same
/// way.
bool triangles_cross(const std::vector<Vec3>& positions, const Triangle& s, const Triangle& t,
                     bool one_sheet);

}  // namespace craze
