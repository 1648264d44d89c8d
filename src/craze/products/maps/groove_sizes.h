// How wide and deep the grooves of maps are.
#pragma once

#include <array>
#include <vector>

#include "craze/products/chips/chips.h"
#include "craze/products/maps/map_surface.h"
#include "craze/recipe.h"

namespace craze {

/// How wide pictures draw cracks, of the diagonal of the surface's box (render/picture.cpp).
inline constexpr double hairline = 0.0021;

/// Width and depth of every crack's groove.
struct GrooveSizes {
  /// Per crack: half the width at its a and b, length: post.gap times the opening; where no
  /// opening is known post.gap_width, and without that, or where there is no gap, that of a
  /// hairline; by post.late_width less of it.
  std::vector<std::array<double, 2>> half_width;
  double wall = 0;  ///< depth; 0: as deep as the groove is wide at each place
  double curl = 0;  ///< lift of the rims, over half the width
  Chips chips;      ///< bites out of their rims
  /// What could not be as asked, one sentence each.
  std::vector<std::string> warnings;

  double depth(double half_width_there) const { return wall > 0 ? wall : 2 * half_width_there; }
};

/// Per crack at its a and b: half of gap times the opening, by post.late_width less.
std::vector<std::array<double, 2>> half_widths(const std::vector<MapCrack>& cracks, double gap,
                                               double late_width);

/// A hairline has the width that pictures draw cracks with. post.gap_width, of a mesh from a file,
/// becomes a gap as in a run.
GrooveSizes groove_sizes(const MapSurface& maps, const PostParameters& post);

}  // namespace craze
