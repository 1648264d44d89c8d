// The transfer curve of sRGB.
#pragma once

#include "craze/base/elementary.h"

namespace craze {

inline float srgb_to_linear(float c) {
  if (c <= 0.04045f) return c / 12.92f;
  return static_cast<float>(elementary::pow((c + 0.055f) / 1.055f, 2.4));
}

inline float linear_to_srgb(float c) {
  if (c <= 0.0031308f) return 12.92f * c;
  return static_cast<float>(1.055 * elementary::exp(elementary::log(c) / 2.4) - 0.055);
}

}  // namespace craze
