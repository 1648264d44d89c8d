// The invariants of TriangleMesh, checked from scratch.
#pragma once

#include <string>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// What is wrong with the mesh, a line per broken invariant and place, at most a hundred; empty if
/// it is sound. Looks at everything the class promises: corners that exist and differ, finite
/// positions, opposite sides that name each other and join the same two roots in opposite
/// directions, one fan per vertex that reaches all its corners and starts at the open edge, and
/// roots that lie where their copies lie. O(#V + #F).
std::vector<std::string> validate(const TriangleMesh& mesh);

}  // namespace craze
