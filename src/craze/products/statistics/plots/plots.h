// Pictures of a pattern and of its statistics, as SVG.
#pragma once

#include <cstdint>
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

/// A mean and its standard error over something that was varied.
struct PlotPoint {
  double x = 0;                ///< where on the axis
  std::string label;           ///< of x
  double mean = 0, error = 0;  ///< error: 0 where it is not known
  std::uint64_t runs = 0;
};

struct ErrorBars {
  std::string title, axis;
  bool logarithmic = false;  ///< the axis; then every x is above 0
  bool joined = true;        ///< by a line: x is a number
};

/// Points with their errors as bars, and as text that a browser shows at them.
std::string error_bars_svg(const std::vector<PlotPoint>& points, const ErrorBars& layout);

/// The graph seen along `view` (a vector from the eye into the scene; lines of surface that faces
/// away are left out). A planar input is seen straight on, whatever the view.
std::string graph_svg(const CrackGraphInput& input, GraphColor color,
                      const StatisticsOptions& options = {}, const Vec3& view = {0, 0, -1});

}  // namespace craze
