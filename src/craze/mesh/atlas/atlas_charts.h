// Parts of a surface that are flat enough to be laid into the plane.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

struct AtlasChart {
  std::vector<std::int32_t> faces;
  /// Of each of them, in the plane: turned counter-clockwise, and none overlaps another.
  std::vector<std::array<Vec2, 3>> corners;
};

/// Grows charts from face to face over shared edges, from the first face that is in none: those
/// whose normals are within acos(1 / most_atlas_stretch) of its own, as long as they stay apart,
/// seen along that normal. `wanted` (#F; empty: all). Faces without area are in none. Throws
/// Cancelled.
std::vector<AtlasChart> atlas_charts(const SurfaceMesh& mesh, const std::vector<char>& wanted,
                                     const Context& context);

}  // namespace craze
