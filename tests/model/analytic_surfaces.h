// Meshes of surfaces whose curvature and geodesics are known, regular and irregular.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "craze/base/random.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze::test {

/// A u × v grid of vertices in [0, 1)², each moved by up to `jitter` of a cell and mapped by
/// point(s, t); cells are split along a diagonal drawn by lot when there is jitter. A direction
/// that wraps joins its last row to its first.
template <class Point>
TriangleMesh grid_surface(int u, int v, bool wrap_u, bool wrap_v, double jitter, std::uint64_t seed,
                          Point&& point) {
  Random random(seed);
  const int rows = wrap_v ? v : v + 1, columns = wrap_u ? u : u + 1;
  std::vector<Vec3> positions;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double a = random.uniform(-jitter, jitter), b = random.uniform(-jitter, jitter);
      const bool fixed_u = !wrap_u && (i == 0 || i == u), fixed_v = !wrap_v && (j == 0 || j == v);
      positions.push_back(point((i + (fixed_u ? 0 : a)) / u, (j + (fixed_v ? 0 : b)) / v));
    }
  }
  const auto at = [&](int i, int j) { return (j % rows) * columns + i % columns; };
  std::vector<Triangle> triangles;
  for (int j = 0; j < v; ++j) {
    for (int i = 0; i < u; ++i) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (jitter > 0 && random.uniform() < 0.5) {
        triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
      } else {
        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      }
    }
  }
  return TriangleMesh(std::move(positions), std::move(triangles));
}

inline TriangleMesh plate(int n, double size, double jitter, std::uint64_t seed = 1) {
  return grid_surface(n, n, false, false, jitter, seed, [&](double s, double t) {
    return Vec3((s - 0.5) * size, (t - 0.5) * size, 0);
  });
}

/// Open, axis z, height = `radius`, n cells around.
inline TriangleMesh cylinder(int n, double radius, double jitter, std::uint64_t seed = 1) {
  return grid_surface(n, n / 6, true, false, jitter, seed, [&](double s, double t) {
    const double a = 2 * std::numbers::pi * s;
    return Vec3(radius * std::cos(a), radius * std::sin(a), radius * t);
  });
}

/// Axis z, n cells around the tube.
inline TriangleMesh torus(int n, double big, double small, double jitter, std::uint64_t seed = 1) {
  const int around = static_cast<int>(n * big / small);
  return grid_surface(around, n, true, true, jitter, seed, [&](double s, double t) {
    const double a = 2 * std::numbers::pi * s, b = 2 * std::numbers::pi * t;
    const double r = big + small * std::cos(b);
    return Vec3(r * std::cos(a), r * std::sin(a), small * std::sin(b));
  });
}

/// An octahedron with each side cut into n, on the sphere, inner vertices moved along it by up to
/// `jitter` of the mean edge.
inline TriangleMesh sphere(int n, double radius, double jitter, std::uint64_t seed = 1) {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::map<std::array<int, 3>, std::int32_t> index;
  Random random(seed);
  const double edge = std::sqrt(4 * std::numbers::pi / (8.0 * n * n) * 4 / std::sqrt(3.0));
  const auto vertex = [&](std::array<int, 3> p) {
    const auto [it, added] = index.try_emplace(p, static_cast<std::int32_t>(positions.size()));
    if (added) {
      Vec3 q = Vec3(p[0], p[1], p[2]).normalized();
      for (int k = 0; k < 3; ++k) q[k] += jitter * edge * random.uniform(-1, 1);
      positions.push_back(radius * q.normalized());
    }
    return it->second;
  };
  for (int octant = 0; octant < 8; ++octant) {
    const int sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
    const bool flip = sx * sy * sz < 0;
    const auto at = [&](int i, int j) { return vertex({sx * i, sy * j, sz * (n - i - j)}); };
    const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
      if (flip) std::swap(b, c);
      triangles.push_back({a, b, c});
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return TriangleMesh(std::move(positions), std::move(triangles));
}

}  // namespace craze::test
