// Colours and their encodings.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "craze/base/elementary.h"
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

/// A gentle film curve: straight up to `knee`, then bending towards white.
inline float tone_curve(float x) {
  constexpr float knee = 0.55f, room = 1 - knee;
  if (x <= knee) return std::max(x, 0.0f);
  // knee + room tanh((x − knee) / room)
  const double e = elementary::exp(2.0 * (x - knee) / room);
  return knee + room * static_cast<float>(1 - 2 / (e + 1));
}

inline float smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

}  // namespace craze::render
