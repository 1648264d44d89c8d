// A crack graph with its scale and the border it is seen through.
#pragma once

#include <optional>
#include <vector>

#include "craze/products/statistics/graph/crack_graph.h"
#include "craze/products/statistics/measures/border_distance.h"
#include "craze/products/statistics/measures/junction_angles.h"
#include "craze/products/statistics/statistics.h"

namespace craze {

/// What is common to all measurements, whatever the length of simplification. Input and options
/// must outlive it.
struct Pattern {
  const CrackGraphInput& input;
  const StatisticsOptions& options;
  std::optional<Window> window;
  CrackGraph raw;   ///< as given
  double unit = 0;  ///< √Ā; where cells cover < 10 %, 2 area/length (as for squares)
  std::vector<BorderSegment> border;  ///< the surface's, or the sides of the window

  Pattern(const CrackGraphInput& graph, const StatisticsOptions& o);

  /// Without spurs and edges shorter than `length` (in units of √Ā).
  CrackGraph simplified(double length) const;
  BranchFit fit() const { return {options.fit_from * unit, options.fit_to * unit}; }
  /// Which nodes lie on the border or nearer to it than the margin.
  std::vector<char> near_border_nodes(const CrackGraph& graph) const;
};

}  // namespace craze
