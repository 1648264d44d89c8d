// Pictures of a pattern and of its statistics, as SVG.
#pragma once

#include <string>
#include <vector>

#include "craze/products/statistics/graph/graph_input.h"
#include "craze/products/statistics/statistics.h"

namespace craze {

struct Histogram {
  std::string title, axis;   ///< what is counted; axis with its unit
  double low = 0, high = 1;  ///< values outside are not shown
  int bins = 20;
  double first_tick = 0;      ///< of the labelled ticks
  double tick = 0.2;          ///< their distance
  std::vector<double> marks;  ///< values marked by a dashed line
};

/// Bars are shares of all values. An empty set gives empty axes.
std::string histogram_svg(const std::vector<double>& values, const Histogram& layout);

std::string angles_svg(const Statistics& statistics);  ///< 90°, 120° and 180° marked
std::string areas_svg(const Statistics& statistics);
std::string sides_svg(const Statistics& statistics);

enum class GraphColor {
  time,      ///< dark (first) to light (last) by rank of time, then event
  junction,  ///< lines grey; T, Y, mixed, X and free ends as coloured dots
};

/// The graph seen along `view` (a vector from the eye into the scene; lines of surface that faces
/// away are left out). A planar input is seen straight on, whatever the view.
std::string graph_svg(const CrackGraphInput& input, GraphColor color,
                      const StatisticsOptions& options = {}, const Vec3& view = {0, 0, -1});

}  // namespace craze
