// Do the cracks prefer a direction?
#pragma once

#include <vector>

#include "craze/products/statistics/estimate.h"
#include "craze/products/statistics/graph/crack_graph.h"

namespace craze {

struct Anisotropy {
  Estimate strength;       ///< S = |ΣL e^{2iθ}| / ΣL over the lines between junctions
  Estimate null;           ///< √(ΣL²)/ΣL: the root mean square of S for directions at random
  Estimate entropy;        ///< of L over 10° bins, divided by ln 18: 1 for none preferred
  Estimate direction;      ///< preferred direction, degrees in [0, 180) from the axis
  Estimate rms_deviation;  ///< of the straight pieces from it, by length, degrees
};

/// Angles are counter-clockwise from `axis` projected into the tangent plane at each line's middle;
/// lines where it vanishes are left out.
Anisotropy measure_anisotropy(const CrackGraph& graph, const Vec3& axis, const Bootstrap& options);

}  // namespace craze
