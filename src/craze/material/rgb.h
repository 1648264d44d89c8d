// Colours as light.
#pragma once

#include <Eigen/Core>

#include "craze/base/srgb.h"

namespace craze::render {

using Vec3f = Eigen::Vector3f;
using Rgb = Eigen::Array3f;  ///< linear, Rec. 709 primaries

/// The linear colour of an 8-bit sRGB triple.
inline Rgb from_srgb(int r, int g, int b) {
  return {srgb_to_linear(r / 255.0f), srgb_to_linear(g / 255.0f), srgb_to_linear(b / 255.0f)};
}

inline float luminance(const Rgb& c) {
  return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2];
}

}  // namespace craze::render
