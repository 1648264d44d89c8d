// The groove that an open crack is: two walls down to the crack's line, as side walls have it.
#pragma once

#include <algorithm>
#include <cmath>

namespace craze {

/// Share of the strip of `width` > 0 around the distance d from the crack's line that lies in a
/// crack of that half width.
inline double covered_share(double d, double half_width, double width) {
  const double low = std::max(d - width / 2, -half_width);
  const double high = std::min(d + width / 2, half_width);
  return std::max(0.0, high - low) / width;
}

/// Depth at the distance d from the line, as a share of the depth there, averaged over the same
/// strip: the exact integral of 1 − |x| / half_width.
inline double mean_depth(double d, double half_width, double width) {
  if (half_width <= 0) return 0;
  const auto integral = [half_width](double x) {
    const double c = std::clamp(x, -half_width, half_width);
    const double rest = half_width - std::abs(c);
    const double tail = rest * rest / (2 * half_width);
    return c <= 0 ? tail : half_width - tail;
  };
  return (integral(d + width / 2) - integral(d - width / 2)) / width;
}

/// The cosine-weighted part of an even sky that the wall sees at the distance d ≤ half_width from
/// the line of a straight groove: (1 + sin φ) / 2, φ the angle from the wall's normal down to the
/// rim across. Its own wall and rim hide nothing.
inline double groove_light(double d, double half_width, double depth) {
  if (half_width <= 0 || d >= half_width) return 1;
  const double across = half_width + d, up = depth * (1 - d / half_width);
  const double slope = std::sqrt(half_width * half_width + depth * depth);
  const double reach = std::sqrt(across * across + up * up);
  return (1 + (half_width * across - depth * up) / (slope * reach)) / 2;
}

}  // namespace craze
