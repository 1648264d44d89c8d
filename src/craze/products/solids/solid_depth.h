// How thick solids can be before they pass through themselves or each other.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/products/solids/solid_shape.h"

namespace craze {

struct SolidDepth {
  std::vector<double> depth;   ///< #V, > 0, the same on a site
  std::int32_t limited = 0;    ///< vertices of the mesh that are less deep than asked for
  double least = 1;            ///< the smallest share of the thickness
  std::int32_t crossings = 0;  ///< pairs of triangles that cross, or are turned over, all the same
  std::vector<std::uint8_t> stuck;  ///< #V, 1 at those pairs
};

/// Starts with `thickness` (> 0), where there is room for it behind the surface, takes back what
/// still makes inner faces turn over or triangles cross, and lets the depth grow no faster along
/// the surface than it goes in. What crosses in the opened surface itself does not count, nor do
/// shells that pass through each other as they are. Throws Cancelled.
SolidDepth limit_depth(const SolidShape& shape, double thickness, const Context& context);

}  // namespace craze
