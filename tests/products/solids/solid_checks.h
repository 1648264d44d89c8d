// What holds of closed solids, found without what made them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "craze/engine.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/shapes.h"

namespace craze::test {

inline Result cracked_mesh(SurfaceMesh mesh, const std::string& preset, double spacing,
                           OutputMesh output = OutputMesh::asset) {
  Recipe recipe = read_preset(preset);
  recipe.mesh.output = output;
  recipe.simulation.layer.relative_spacing = spacing;
  Input input;
  input.surface = std::make_shared<const SurfaceMesh>(std::move(mesh));
  return crack(std::move(input), recipe, {}, {});
}

inline Result cracked_shape(const std::string& shape, const std::string& preset, double spacing,
                            OutputMesh output = OutputMesh::asset) {
  return cracked_mesh(make_shape(shape), preset, spacing, output);
}

/// Every edge is used as often one way as the other, and at most once each.
inline bool is_closed(const SurfaceMesh& solid) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> uses;
  for (const Triangle& t : solid.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : uses) {
    if (count != 1 || uses.count({edge.second, edge.first}) != 1) return false;
  }
  return !uses.empty();
}

/// By the divergence theorem, about a corner of its own.
inline double volume_of(const SurfaceMesh& solid) {
  double six = 0;
  const Vec3& o = solid.positions[0];
  for (const Triangle& t : solid.triangles) {
    six +=
        (solid.positions[t[0]] - o).cross(solid.positions[t[1]] - o).dot(solid.positions[t[2]] - o);
  }
  return six / 6;
}

inline double area_of(const SurfaceMesh& mesh) {
  double twice = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& o = mesh.positions[t[0]];
    twice += (mesh.positions[t[1]] - o).cross(mesh.positions[t[2]] - o).norm();
  }
  return twice / 2;
}

/// How often a closed surface runs around p: the sum of its solid angles (Van Oosterom and
/// Strackee, 1983). `is_on`: whether p lies on a triangle, to rounding, which then covers half of
/// what there is to see or, from its rim, a part of that: on which side is a matter of the last
/// bit.
inline double winding(const SurfaceMesh& solid, const Vec3& p, bool& is_on) {
  constexpr double rounding = 1e-7;
  double sum = 0;
  is_on = false;
  for (const Triangle& t : solid.triangles) {
    const Vec3 a = solid.positions[t[0]] - p, b = solid.positions[t[1]] - p,
               c = solid.positions[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm(), most = rounding * la * lb * lc;
    const double up = a.cross(b).dot(c),
                 along = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    is_on = is_on || (std::abs(up) <= most && along <= most);
    sum += std::atan2(up, along);
  }
  return sum / (2 * std::numbers::pi);
}

inline bool box_holds(const SurfaceMesh& solid, const Vec3& p) {
  Vec3 low = solid.positions[0], high = low;
  for (const Vec3& q : solid.positions) {
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  return (p - low).minCoeff() >= 0 && (high - p).minCoeff() >= 0;
}

/// Of random points within the solids' reach that lie on none of them, the largest number of times
/// that one is inside.
inline int most_often_inside(const std::vector<SurfaceMesh>& solids, int points) {
  std::mt19937 random(1);
  int most = 0;
  int used = 0;
  for (int tries = 0; used < points && tries < 100 * points; ++tries) {
    // Near a vertex of some solid, where walls meet.
    const SurfaceMesh& solid = solids[random() % solids.size()];
    const Triangle& t = solid.triangles[random() % solid.triangles.size()];
    std::uniform_real_distribution<double> share(0.05, 0.9);
    const Vec3 inside = (solid.positions[t[0]] + solid.positions[t[1]] + solid.positions[t[2]]) / 3;
    const Vec3& to = solid.positions[random() % solid.positions.size()];
    const Vec3 p = inside + share(random) * (to - inside);
    double times = 0;
    bool on_any = false;
    for (const SurfaceMesh& other : solids) {
      if (!box_holds(other, p)) continue;
      bool is_on = false;
      times += std::round(winding(other, p, is_on));
      on_any = on_any || is_on;
    }
    if (on_any) continue;
    ++used;
    most = std::max(most, static_cast<int>(times));
  }
  EXPECT_EQ(used, points) << "too few points lie off the surfaces";
  return most;
}

}  // namespace craze::test
