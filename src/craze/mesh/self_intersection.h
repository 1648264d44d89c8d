// Where a surface passes through itself.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The pairs of triangles (lower index first, ascending) that cross: an edge of one goes through
/// the inside of the other, by more than rounding. Triangles that share a corner, by index or by
/// place, cross where the opposite edge of one goes through the other; those that share two do not.
/// Touching, and lying on each other in one plane, is no crossing. At most `limit` pairs. Throws
/// Cancelled.
std::vector<std::array<std::int32_t, 2>> self_intersections(const std::vector<Vec3>& positions,
                                                            const std::vector<Triangle>& triangles,
                                                            std::size_t limit = SIZE_MAX,
                                                            const Context& context = {});

}  // namespace craze
