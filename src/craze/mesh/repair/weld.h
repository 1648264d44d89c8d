// Finds vertices that lie in the same place.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/tensor.h"

namespace craze {

/// #V: for each position the lowest index of those it is merged with, itself if none. A position
/// joins the first earlier one within `tolerance` (0: exactly equal) that joined no other, so
/// merging never runs along a chain of near points. Positions must be finite. O(#V) expected.
std::vector<std::int32_t> weld(const std::vector<Vec3>& positions, double tolerance);

}  // namespace craze
