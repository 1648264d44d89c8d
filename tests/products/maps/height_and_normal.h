// The normal map beside the slope of the height map.
#pragma once

#include <algorithm>
#include <cmath>

#include "craze/maps.h"

namespace craze::test {

/// Degrees between the two at the texel where they differ most, those at the borders left out.
/// Both maps are `size` wide and high and show a unit square; heights are lengths.
inline double largest_tilt(const Map& height, const Map& normal, int size) {
  const std::vector<float>&h = height.values, &colors = normal.values;
  double largest = 0;
  for (int y = 1; y + 1 < size; ++y) {
    for (int x = 1; x + 1 < size; ++x) {
      const auto i = static_cast<std::size_t>(y * size + x);
      const Vec3 slope(-(h[i + 1] - h[i - 1]) * size / 2, -(h[i - size] - h[i + size]) * size / 2,
                       1);
      const Vec3 shown(2 * colors[3 * i] - 1, 2 * colors[3 * i + 1] - 1, 2 * colors[3 * i + 2] - 1);
      const double sine = std::min(1.0, slope.normalized().cross(shown).norm());
      largest = std::max(largest, std::asin(sine) * 180 / std::acos(-1.0));
    }
  }
  return largest;
}

}  // namespace craze::test
