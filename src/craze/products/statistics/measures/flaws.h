// Cracks that went nowhere: dead ends, spurs, micro-cracks.
#pragma once

#include <vector>

#include "craze/products/statistics/estimate.h"
#include "craze/products/statistics/graph/crack_graph.h"

namespace craze {

/// Each a share of the crack length.
struct Flaws {
  Estimate dead_ends;     ///< lines with a free tip
  Estimate spurs;         ///< those shorter than a quarter of the spacing, ending on another crack
  Estimate micro_cracks;  ///< cracks that touch nothing, shorter in all than a quarter
};

/// Of a graph before pruning. ignored[n]: a tip there is not one (the picture ends there).
Flaws measure_flaws(const CrackGraph& graph, double spacing, const std::vector<char>& ignored);

}  // namespace craze
