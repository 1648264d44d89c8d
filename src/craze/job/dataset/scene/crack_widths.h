// How wide cracks are drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/job/dataset/scene/whole_cracks.h"

namespace craze {

struct WidthStyle {
  double mean = 1;        ///< length
  double even = 0.5;      ///< 0: each crack in proportion to its mean opening; 1: all alike
  double unevenness = 0;  ///< relative, along a crack
  double taper = 0;       ///< length over which a free tip closes
  std::uint64_t seed = 1;
};

/// Full widths, length: for each crack one per node, linear between. 0 at free tips.
using CrackWidths = std::vector<std::vector<double>>;

CrackWidths crack_widths(const CrackNetwork& network, const std::vector<WholeCrack>& cracks,
                         const WidthStyle& style);

}  // namespace craze
