// UVs for a surface that has none of its own.
#pragma once

#include <vector>

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

/// No length on the surface is longer than this times what it is in the UVs, times the same scale
/// for all charts; none is shorter.
inline constexpr double most_atlas_stretch = 4.0 / 3;

/// 3 #F UVs in 0 … 1, corner i of triangle f at 3f+i: flat charts side by side that do not overlap,
/// all of one scale. Triangles that are not `wanted` (#F; empty: all are) and those without area
/// are in no chart, all their corners at 0. Vertices that coincide are one, so the mesh may be
/// open along seams. Deterministic. Throws Cancelled.
std::vector<Vec2> uv_atlas(const SurfaceMesh& mesh, const std::vector<char>& wanted,
                           const Context& context);

}  // namespace craze
