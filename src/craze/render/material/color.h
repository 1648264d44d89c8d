// Colours as a camera shows them.
#pragma once

#include <algorithm>

#include "craze/base/elementary.h"
#include "craze/material/rgb.h"

namespace craze::render {

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
