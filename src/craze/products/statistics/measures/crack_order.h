// The order in which cracks opened, by their times and as the geometry tells it.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/products/statistics/estimate.h"
#include "craze/products/statistics/measures/junction_angles.h"

namespace craze {

struct CrackOrder {
  /// Share of T-junctions whose leg opened after both halves of its crossbar. Of T's with equal
  /// times none is counted.
  Estimate leg_younger;
  /// Kendall's τ between time and geometry over the pairs of cracks that the geometry orders: a
  /// crack that ends on another comes after it and after all that one comes after. 1: sequential.
  Estimate kendall_tau;
};

/// counted[n]: whether node n is among the T's of leg_younger; all T's order the cracks. NaN where
/// the input has neither times nor events.
CrackOrder measure_order(const CrackGraph& graph, const std::vector<std::vector<double>>& sectors,
                         double tolerance, const std::vector<char>& counted,
                         const Bootstrap& options);

}  // namespace craze
