// A grey picture as a function on texture space.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "craze/tensor.h"

namespace craze {

/// Rows from the top; 0 black, 1 white, as stored (no gamma). Empty: not given.
struct GreyImage {
  std::int32_t width = 0, height = 0;
  std::vector<float> pixels;  ///< width · height

  bool empty() const { return pixels.empty(); }
  /// Bilinear between pixel centres; u runs right and v up from the lower left corner, both repeat.
  /// Not for an empty image; a uv that is not finite counts as (0, 0).
  double sample(const Vec2& uv) const;
  /// Whether any of the pixels that sample() mixes there is 0.
  bool touches_black(const Vec2& uv) const;
};

/// The pictures of a recipe, by the name that it has for each (stress.texture, material.texture,
/// layer.texture).
using Textures = std::map<std::string, GreyImage>;

}  // namespace craze
