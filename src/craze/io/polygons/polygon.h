// Triangles from a polygon.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "craze/tensor.h"

namespace craze {

/// The most corners a polygon that is not convex may have: ear clipping takes quadratic time.
inline constexpr std::size_t max_concave_corners = 4096;

/// Corner numbers 0 … n−1 of a polygon, three to a triangle.
using CornerTriple = std::array<std::int32_t, 3>;

/// Appends n − 2 triangles that tile the polygon, oriented as it is. A convex one becomes a fan
/// about corner 0; others are clipped ear by ear in their best-fit plane (Newell's normal), which
/// also ends, with some overlap, where the outline crosses itself. Returns false, and appends
/// nothing, for a polygon that is not convex and has more than max_concave_corners.
bool triangulate_polygon(std::span<const Vec3> corners, std::vector<CornerTriple>& triangles);

}  // namespace craze
