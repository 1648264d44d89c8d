// Points of a triangle in whole numbers, so that every question about sides has an exact answer.
#pragma once

#include <cstdint>

#include "craze/tensor.h"

namespace craze {

/// Barycentric coordinates are multiples of 1/grid. The grid is affine: a needle has the same one
/// as an equilateral triangle, and a point of an edge lies on it exactly, seen from any face.
constexpr std::int32_t grid = 1 << 30;

/// Weights of corners 1 and 2 of a face in units of 1/grid; corner 0 has the rest. x, y and
/// grid − x − y are all ≥ 0.
struct GridPoint {
  std::int32_t x = 0, y = 0;

  friend bool operator==(const GridPoint& a, const GridPoint& b) {
    return a.x == b.x && a.y == b.y;
  }
};

/// Barycentric coordinates; exact, and their sum is exactly 1.
inline Vec3 weights_of(const GridPoint& p) {
  constexpr double unit = 1.0 / grid;
  return {unit * (grid - p.x - p.y), unit * p.x, unit * p.y};
}

/// The point of edge i, from corner i to corner i+1, at s/grid of the way.
inline GridPoint on_grid_edge(int i, std::int32_t s) {
  if (i == 0) return {s, 0};
  if (i == 1) return {grid - s, s};
  return {0, grid - s};
}

/// Twice the area of abc in grid units, positive if counter-clockwise. Exact: below 2⁶².
inline std::int64_t orient(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

}  // namespace craze
