// A pattern of the ground (material/pattern.h) at a place.
#pragma once

#include "craze/material/pattern.h"
#include "craze/render/material/color.h"

namespace craze::render {

/// What a pattern does to a place.
struct PatternSample {
  Rgb tint = Rgb::Ones();      ///< factor of the colour
  Vec3f tilt = Vec3f::Zero();  ///< added to the normal
};

/// `place` is not shifted yet; edges are as soft as `footprint`, the size of a pixel there.
PatternSample pattern_at(const Pattern& pattern, const Vec3f& place, float footprint);

}  // namespace craze::render
