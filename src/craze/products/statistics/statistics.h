// The numbers that describe a crack pattern. docs/statistics.md defines each.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/products/statistics/estimate.h"
#include "craze/products/statistics/graph/graph_input.h"

namespace craze {

/// Lengths are in units of √Ā, the root of the mean cell area.
struct StatisticsOptions {
  double simplify = 0.05;          ///< spurs shorter than this are pruned, edges contracted
  double border_margin = 1;        ///< junctions nearer to an open border are left out
  double fit_from = 0.05;          ///< r₁ of the line fitted to each branch
  double fit_to = 0.4;             ///< r₂
  double tolerance = 20;           ///< degrees: what still counts as 180° (T) or 120° (Y)
  Vec3 axis = Vec3::UnitX();       ///< directions are measured from it
  Bootstrap bootstrap = {100, 1};  ///< its context is asked between all measurements
};

/// A quantity that was not measured is NaN. quantities.h gives each its key and meaning.
struct Statistics {
  std::int64_t junctions = 0;    ///< measured: three or more cracks, away from the border
  std::int64_t cells = 0;        ///< measured: closed, none of their sides on the border
  std::int64_t cells_found = 0;  ///< with those at the border
  std::int64_t edges = 0;        ///< measured, between junctions
  double crack_length = 0;       ///< model units
  double surface_area = 0;       ///< model units squared; 0: not known

  Estimate mean_area, root_area, area_over_perimeter;
  Estimate length_per_area;
  Estimate ends, threes, crosses, mean_degree;
  Estimate angle_min, angle_mid, angle_max, angle_sd;
  Estimate t_fraction, y_fraction, mixed_fraction, leg_angle, leg_sd;
  Estimate sides, corner_degree, regular, sides_from_nodes, sides_flat, sides_combinatorial;
  Estimate curvature;
  Estimate area_cv, area_sd_log, gamma_shape, gamma_over_lognormal, slivers;
  Estimate circularity, circularity_sd;
  Estimate edge_cv, tortuosity;
  Estimate anisotropy, anisotropy_null, direction_entropy, direction, direction_rms;
  Estimate leg_younger, kendall_tau;
  Estimate dead_ends, spurs, micro_cracks;

  struct Samples {
    std::vector<double> angles;  ///< degrees, all three of each measured junction of three
    std::vector<double> areas;   ///< of measured cells, over their mean
    std::vector<double> sides;   ///< of measured cells
  } samples;
};

/// The statistics, and how they change with the length below which the graph is simplified.
struct StatisticsWithSensitivity {
  Statistics result, at_half, at_double;  ///< the last two without errors
};

/// Throws Cancelled.
Statistics compute_statistics(const CrackGraphInput& input, const StatisticsOptions& options = {});

/// Throws Cancelled.
StatisticsWithSensitivity compute_with_sensitivity(const CrackGraphInput& input,
                                                   const StatisticsOptions& options = {});

}  // namespace craze
