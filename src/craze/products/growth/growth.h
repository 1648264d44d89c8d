// An opened surface as it comes to be, crack by crack: its positions at any time of a clip.
#pragma once

#include <array>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/mesh/morph_animation.h"
#include "craze/products/growth/growth_motion.h"
#include "craze/products/growth/growth_times.h"
#include "craze/products/opening/opened_surface.h"

namespace craze {

/// Times of the clip run from 0, no crack, to 1, all of them. Keeps references to what it is given.
class Growth {
 public:
  /// `opened` was made of `result`.
  Growth(const Result& result, const OpenedSurface& opened);

  /// #V of the opened mesh, model units: its vertices at a time of the clip. The triangles stay.
  std::vector<Vec3> positions_at(double time) const { return motion_.positions(time); }

  /// #V of the opened mesh, 0 … 1: how far the crack at the vertex has opened; 0 away from cracks.
  std::vector<double> openness_at(double time) const;

  /// The same per side of a crack (CrackSites::sides), at its two ends.
  std::vector<std::array<float, 2>> side_openness_at(double time) const;

  /// The clip in `stages` steps of equal length. Throws Cancelled.
  MorphAnimation animation(int stages, double seconds, const Context& context) const;

 private:
  const OpenedSurface& opened_;
  GrowthMotion motion_;
};

}  // namespace craze
