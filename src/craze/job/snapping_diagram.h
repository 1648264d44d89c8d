// [IO06 Fig. 5] as a drawing.
#pragma once

#include <string>

namespace craze {

/// An SVG of three places before and after open_crack(): a crack through triangles, one that snaps
/// to a mesh edge within θ₁, one whose segment within θ₂ of an older crack is dropped. What is
/// drawn are the meshes themselves; after the cut their vertices are moved apart to show what is
/// open.
std::string snapping_diagram();

}  // namespace craze
