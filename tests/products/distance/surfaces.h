// Surfaces to test on.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "craze/base/random.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze::test {

/// n × m cells of two triangles; place(i / n, j / m) puts the points. `wrap_x`, `wrap_y` close it.
template <class Place>
TriangleMesh grid(int n, int m, bool wrap_x, bool wrap_y, Place place) {
  const int columns = wrap_x ? n : n + 1, rows = wrap_y ? m : m + 1;
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) positions.push_back(place(double(i) / n, double(j) / m));
  }
  const auto at = [&](int i, int j) { return (j % rows) * columns + i % columns; };
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < n; ++i) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return {positions, triangles};
}

/// The unit square in the plane z = 0, its inner points displaced by up to jitter / n.
inline TriangleMesh plate(int n, double jitter) {
  Random random(3);
  return grid(n, n, false, false, [&](double x, double y) {
    const bool inside = x > 0 && x < 1 && y > 0 && y < 1;
    const double s = inside ? jitter / n : 0;
    return Vec3(x + s * random.uniform(-1, 1), y + s * random.uniform(-1, 1), 0);
  });
}

/// Radii 1 and 0.4, axis y, oriented outwards.
inline TriangleMesh torus(int n) {
  return grid(n, n, true, true, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v;
    const double r = 1 + 0.4 * std::cos(b);
    return Vec3(r * std::cos(a), 0.4 * std::sin(b), -r * std::sin(a));
  });
}

/// Cuts edges picked at random, wherever they lie, after splitting some open edges on one side.
inline void cut_at_random(TriangleMesh& mesh, int cuts, int splits, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < cuts; ++i) {
    const auto h = static_cast<std::int32_t>(random.below(3 * mesh.face_count()));
    if (!mesh.is_open(h)) mesh.cut(h, i);
    for (int k = 0; k < splits; ++k) {
      const auto g = static_cast<std::int32_t>(random.below(3 * mesh.face_count()));
      mesh.split_edge(g, random.uniform(0.2, 0.8));
    }
  }
}

}  // namespace craze::test
