// What triangles have at their corners, on a surface that was made of them.
#pragma once

#include <vector>

#include "craze/surface_mesh.h"
#include "craze/surface_origin.h"

namespace craze {

/// The weighted sum of three values, in their order, those without weight left out. A weight of 1
/// alone gives an exact copy.
template <class Value>
auto interpolate_corners(const Vec3& weights, Value&& value) {
  int i = 0;
  while (i < 2 && weights[i] == 0) ++i;
  auto sum = value(i);
  if (weights[i] == 1) return sum;
  sum *= weights[i];
  for (++i; i < 3; ++i) {
    if (weights[i] != 0) sum += weights[i] * value(i);
  }
  return sum;
}

/// UVs at the corners of an input's triangles, at those of a surface that was made of it.
std::vector<Vec2> uvs_on_surface(const std::vector<Vec2>& corners, const SurfaceOrigin& origin);

}  // namespace craze
