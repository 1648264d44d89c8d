// How far points lie from the border of the surface, up to a limit.
#pragma once

#include <vector>

#include "craze/tensor.h"

namespace craze {

struct BorderSegment {
  Vec3 a, b;
};

/// For each point: does a segment pass within `limit` of it (straight distance, > 0)?
std::vector<char> near_border(const std::vector<Vec3>& points,
                              const std::vector<BorderSegment>& border, double limit);

}  // namespace craze
