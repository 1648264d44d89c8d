// Plates with cracks whose every point is known.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "craze/base/segment_distance.h"
#include "craze/maps.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/shapes.h"

namespace craze {

/// The unit plate of 2 n² triangles, u and v along x and y, whole but for the given cracks, which
/// lie on it anywhere.
inline MapSurface plate_with(int n, std::vector<MapCrack> cracks) {
  MapSurface maps;
  SurfaceMesh& s = maps.surface;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      s.positions.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n, 0);
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const std::int32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      s.triangles.push_back({a, b, d});
      s.triangles.push_back({a, d, c});
    }
  }
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    for (const std::int32_t v : s.triangles[f]) s.corner_uvs.push_back(s.positions[v].head<2>());
    maps.pieces.push_back(
        {static_cast<std::int32_t>(f),
         0,
         {s.corner_uvs[3 * f], s.corner_uvs[3 * f + 1], s.corner_uvs[3 * f + 2]}});
  }
  for (MapCrack& crack : cracks) {
    const Vec3 p = crack.a * n;
    const int i = std::min(n - 1, static_cast<int>(p.x())),
              j = std::min(n - 1, static_cast<int>(p.y()));
    crack.face = 2 * (j * n + i) + (p.y() - j > p.x() - i ? 1 : 0);
  }
  maps.cracks = std::move(cracks);
  return maps;
}

inline MapCrack crack_from(double ax, double ay, double bx, double by, double width_a,
                           double width_b) {
  MapCrack crack;
  crack.a = {ax, ay, 0};
  crack.b = {bx, by, 0};
  crack.width = {width_a, width_b};
  return crack;
}

/// A T-junction, a bend, a tip that tapers off, and a crack alone.
inline std::vector<MapCrack> known_cracks() {
  return {crack_from(0, 0.31, 0.55, 0.42, 0.05, 0.05), crack_from(0.55, 0.42, 1, 0.38, 0.05, 0.04),
          crack_from(0.55, 0.42, 0.47, 0.83, 0.03, 0),
          crack_from(0.71, 0.62, 0.93, 0.91, 0.02, 0.02)};
}

inline MapOptions options_of(int size, std::vector<MapKind> kinds) {
  MapOptions options;
  options.size = size;
  options.maps = std::move(kinds);
  options.post.gap = 1;
  options.post.wall = 0.02;
  return options;
}

inline std::vector<Map> bake(const MapSurface& maps, const MapOptions& options, int threads = 1) {
  std::vector<Map> baked;
  MapsInMemory sink(baked);
  Context context;
  context.threads = threads;
  bake_surface(maps, options, sink, context);
  return baked;
}

inline double distance_to(const MapCrack& crack, const Vec3& p) {
  return point_segment_distance(p, crack.a, crack.b);
}

/// Whether the open crack holds the point.
inline bool is_in(const MapCrack& crack, const Vec3& p) {
  const double t = nearest_on_segment(p, crack.a, crack.b);
  return distance_to(crack, p) < (crack.width[0] + t * (crack.width[1] - crack.width[0])) / 2;
}

/// Where the middle of a texel lies on the plate.
inline Vec3 middle(int x, int y, int size) {
  return {(x + 0.5) / size, 1 - (y + 0.5) / size, 0};
}

}  // namespace craze
