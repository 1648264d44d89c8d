// Finds the faces of a soup that say nothing new.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// Of `candidates` (ascending face indices) those to keep, ascending. Of faces with the same three
/// corners at most one stays, facing as most of them do. Where as many face one way as the other
/// they form a sheet with two sides: it stays as a single layer if it stands alone or closes more
/// edges than it crowds (a lid); both layers stay if it is the wall between two solids that touch,
/// closed without it all around; and it goes if it is a fin, with an edge that is free. O(#F log
/// #F).
std::vector<std::int32_t> distinct_faces(const std::vector<Triangle>& triangles,
                                         const std::vector<std::int32_t>& candidates);

}  // namespace craze
