// When each point of each crack opens, as the clock of an animation.
#pragma once

#include <array>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/crack_network.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

/// A clip lasts from 0 to 1. Load factors cannot be its clock as they are: under quasi-static
/// loading a crack runs across a piece at one load, and would pop up whole.
struct CrackSchedule {
  /// Part of the clip that the longest crack takes to run through; the others are as fast.
  static constexpr double longest_run = 0.3;
  /// Part of the clip that a point takes to open once the crack has come.
  static constexpr double opening_time = 0.05;

  /// Per side (CrackSites::sides): when the crack comes to its from() and to(), in
  /// 0 … 1 − opening_time.
  std::vector<std::array<double, 2>> sides;
  std::vector<double> sites;  ///< per site: when the first crack comes

  /// How far a point has opened, 0 … 1, where the crack came at `arrival`.
  static double openness(double arrival, double time);
};

/// A crack starts when its load is reached, at the earliest when the crack that it starts from has
/// come by, and then runs on at a constant speed. The load goes evenly with the clip's time from
/// the first crack on. `network` is that of the mesh.
CrackSchedule crack_schedule(const TriangleMesh& mesh, const CrackSites& sites,
                             const CrackNetwork& network);

}  // namespace craze
