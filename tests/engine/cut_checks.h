// What must hold of every asset that was cut.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

#include "craze/engine/asset/cut_asset.h"
#include "craze/engine/asset/cut_surface.h"
#include "craze/mesh/repair/weld.h"

namespace craze::test {

using Ends = std::pair<std::int32_t, std::int32_t>;

template <class T>
bool same_bits(const T* a, const T* b, std::size_t n) {
  return std::memcmp(a, b, n * sizeof(T)) == 0;
}

inline Vec3 area_vector(const std::vector<Vec3>& p, const Triangle& t) {
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
}

inline double diagonal(const SurfaceMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  return box.diagonal().norm();
}

inline double largest_coordinate(const SurfaceMesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

/// Vertices and faces of the asset stay where they are, and faces off the curves as they are.
inline void check_kept(const SurfaceMesh& asset, const CutAsset& cut) {
  ASSERT_GE(cut.positions.size(), asset.positions.size());
  ASSERT_GE(cut.triangles.size(), asset.triangles.size());
  ASSERT_EQ(cut.new_vertices.size(), cut.positions.size() - asset.positions.size());
  ASSERT_TRUE(same_bits(cut.positions.data(), asset.positions.data(), asset.positions.size()));
  std::set<Vec3, bool (*)(const Vec3&, const Vec3&)> on_crack([](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  for (const CutEdge& e : cut.edges) {
    for (const std::int32_t h : e.side) {
      if (h < 0) continue;
      on_crack.insert(cut.positions[cut.triangles[h / 3][h % 3]]);
      on_crack.insert(cut.positions[cut.triangles[h / 3][(h + 1) % 3]]);
    }
  }
  for (std::size_t f = 0; f < asset.triangles.size(); ++f) {
    ASSERT_EQ(cut.face_source[f], static_cast<std::int32_t>(f));
    if (std::binary_search(cut.parts.begin(), cut.parts.end(), static_cast<std::int32_t>(f))) {
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      const std::int32_t v = cut.triangles[f][i], old = asset.triangles[f][i];
      if (v == old) continue;
      ASSERT_EQ(cut.positions[v], asset.positions[old]);
      ASSERT_TRUE(on_crack.count(cut.positions[v])) << "face " << f << " is on no crack";
    }
  }
}

/// Parts tile their face in its plane: exactly in its own coordinates, to rounding in space.
inline void check_parts(const SurfaceMesh& asset, const CutAsset& cut) {
  std::map<std::int32_t, double> share, area;
  const double rounding = 1e-15 * largest_coordinate(asset);
  for (std::size_t p = 0; p < cut.parts.size(); ++p) {
    const std::int32_t f = cut.parts[p], source = cut.face_source[f];
    const Triangle &t = cut.triangles[f], &s = asset.triangles[source];
    Mat3 weights;
    for (int i = 0; i < 3; ++i) weights.col(i) = cut.part_weights[3 * p + i];
    ASSERT_GE(weights.minCoeff(), 0);
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(weights.col(i).sum(), 1);
      const Vec3 expected = weights(0, i) * asset.positions[s[0]] +
                            weights(1, i) * asset.positions[s[1]] +
                            weights(2, i) * asset.positions[s[2]];
      ASSERT_LE((cut.positions[t[i]] - expected).norm(), 4 * rounding);
    }
    ASSERT_GT(weights.determinant(), 0) << "a part of face " << source << " is turned over";
    share[source] += weights.determinant();
    const Vec3 whole = area_vector(asset.positions, s), part = area_vector(cut.positions, t);
    if (!whole.isZero(0)) {
      ASSERT_GT(part.dot(whole), 0) << "face " << source;
    }
    area[source] += part.norm();
  }
  for (const auto& [source, sum] : share) {
    ASSERT_NEAR(sum, 1, 1e-12);
    const Triangle& s = asset.triangles[source];
    const double whole = area_vector(asset.positions, s).norm();
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
      longest = std::max(longest, (asset.positions[s[i]] - asset.positions[s[(i + 1) % 3]]).norm());
    }
    ASSERT_NEAR(area[source], whole, 1e-9 * whole + 100 * rounding * longest);
  }
}

/// Faces at each edge, by place; the same everywhere but where a curve splits an edge.
inline std::map<Ends, std::vector<std::int32_t>> sides_by_place(
    const std::vector<std::int32_t>& place, const std::vector<Triangle>& triangles) {
  std::map<Ends, std::vector<std::int32_t>> sides;
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(3 * triangles.size()); ++h) {
    const Ends ends =
        std::minmax(place[triangles[h / 3][h % 3]], place[triangles[h / 3][(h + 1) % 3]]);
    if (ends.first != ends.second) sides[ends].push_back(h);
  }
  return sides;
}

/// No gap and no overlap: along each edge of the asset its parts have as many faces as it had, and
/// the new edges inside faces two. Exactly the edges that the cut names are parted.
inline void check_joined(const SurfaceMesh& asset, const CutAsset& cut) {
  const auto place = weld(cut.positions, 0);
  const auto before = sides_by_place(weld(asset.positions, 0), asset.triangles);
  const auto after = sides_by_place(place, cut.triangles);
  std::map<Ends, const CutEdge*> cracks;
  for (const CutEdge& e : cut.edges) {
    const std::int32_t h = e.side[0] >= 0 ? e.side[0] : e.side[1];
    ASSERT_GE(h, 0);
    const Ends ends =
        std::minmax(place[cut.triangles[h / 3][h % 3]], place[cut.triangles[h / 3][(h + 1) % 3]]);
    ASSERT_TRUE(cracks.emplace(ends, &e).second) << "an edge is cut twice";
    for (const std::int32_t side : e.side) {
      if (side < 0) continue;
      const auto& halfedges = after.at(ends);
      ASSERT_TRUE(std::count(halfedges.begin(), halfedges.end(), side));
    }
  }
  std::map<std::size_t, int> counts_before, counts_after;
  for (const auto& [ends, halfedges] : before) ++counts_before[halfedges.size()];
  for (const auto& [ends, halfedges] : after) {
    ++counts_after[halfedges.size()];
    ASSERT_TRUE(halfedges.size() == 2 || counts_before.count(halfedges.size()))
        << halfedges.size() << " faces at an edge";
    if (halfedges.size() != 2) continue;
    const auto vertex = [&](std::int32_t h) { return cut.triangles[h / 3][h % 3]; };
    const auto end = [&](std::int32_t h) { return cut.triangles[h / 3][(h + 1) % 3]; };
    const bool joined =
        vertex(halfedges[0]) == end(halfedges[1]) && vertex(halfedges[1]) == end(halfedges[0]);
    ASSERT_FALSE(joined && cracks.count(ends)) << "a crack is shut";
  }
  // Length of the borders is kept: no slit but the cracks.
  const auto length = [](const std::map<Ends, std::vector<std::int32_t>>& edges,
                         const std::vector<Vec3>& p) {
    double sum = 0;
    for (const auto& [ends, h] : edges) {
      if (h.size() != 2) sum += (p[ends.first] - p[ends.second]).norm();
    }
    return sum;
  };
  const double border = length(before, asset.positions);
  ASSERT_NEAR(length(after, cut.positions), border, 1e-9 * border + 1e-12 * diagonal(asset));
}

/// Every curve edge is a chain of cut edges, no longer than `detour` times its chord.
inline void check_chains(const CrackCurves& curves, const CutAsset& cut, double detour,
                         double slack) {
  ASSERT_EQ(cut.point_vertex.size(), curves.points.size());
  const auto place = weld(cut.positions, 0);
  std::map<std::int32_t, std::vector<std::int32_t>> beside;
  for (const CutEdge& e : cut.edges) {
    const std::int32_t h = e.side[0] >= 0 ? e.side[0] : e.side[1];
    const std::int32_t a = place[cut.triangles[h / 3][h % 3]],
                       b = place[cut.triangles[h / 3][(h + 1) % 3]];
    beside[a].push_back(b);
    beside[b].push_back(a);
  }
  for (const auto& [p, q] : curves.edges) {
    const std::int32_t from = place[cut.point_vertex[p]], to = place[cut.point_vertex[q]];
    std::map<std::int32_t, double> reached{{from, 0}};
    std::priority_queue<std::pair<double, std::int32_t>> queue;
    queue.emplace(0, from);
    const double most = detour * (cut.positions[from] - cut.positions[to]).norm() + slack;
    bool found = false;
    while (!queue.empty() && !found) {
      const auto [minus, v] = queue.top();
      queue.pop();
      found = v == to;
      if (-minus > reached[v]) continue;
      for (const std::int32_t w : beside[v]) {
        const double d = -minus + (cut.positions[v] - cut.positions[w]).norm();
        const auto known = reached.find(w);
        if (d > most || (known != reached.end() && known->second <= d)) continue;
        reached[w] = d;
        queue.emplace(-d, w);
      }
    }
    ASSERT_TRUE(found) << "no chain of at most " << most << " from point " << p << " to " << q;
  }
}

/// A curve's end that nothing else touches is one vertex; a point inside a curve is at least two.
inline void check_tips(const SurfaceMesh& asset, const CutAsset& cut) {
  const auto own = weld(asset.positions, 0);
  for (std::size_t v = 0; v < own.size(); ++v) {
    if (own[v] != static_cast<std::int32_t>(v)) return;  // seams part vertices as well
  }
  const auto place = weld(cut.positions, 0);
  const auto after = sides_by_place(place, cut.triangles);
  std::map<std::int32_t, int> degree;
  std::set<std::int32_t> border;
  for (const CutEdge& e : cut.edges) {
    const std::int32_t h = e.side[0] >= 0 ? e.side[0] : e.side[1];
    ++degree[place[cut.triangles[h / 3][h % 3]]];
    ++degree[place[cut.triangles[h / 3][(h + 1) % 3]]];
  }
  for (const auto& [ends, halfedges] : after) {
    if (halfedges.size() == 2) continue;
    border.insert(ends.first);
    border.insert(ends.second);
  }
  std::map<std::int32_t, std::set<std::int32_t>> vertices;
  for (const Triangle& t : cut.triangles) {
    for (const std::int32_t v : t) vertices[place[v]].insert(v);
  }
  for (const auto& [p, d] : degree) {
    if (border.count(p)) continue;
    ASSERT_EQ(vertices[p].size(), static_cast<std::size_t>(d)) << "at place " << p;
  }
}

/// Attributes of parts are those of their face's corners, weighted.
inline void check_attributes(const SurfaceMesh& asset, const CutAsset& cut) {
  const SurfaceMesh made = cut_surface(asset, cut, cut.positions, cut.triangles);
  ASSERT_EQ(made.corner_uvs.size(), 3 * cut.triangles.size());
  ASSERT_EQ(made.corner_normals.size(), 3 * cut.triangles.size());
  ASSERT_EQ(made.vertex_colors.size(), cut.positions.size());
  const double size = largest_coordinate(asset);
  std::set<std::int32_t> parts(cut.parts.begin(), cut.parts.end());
  for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
    const std::size_t source = cut.face_source[f];
    ASSERT_EQ(made.face_materials[f], asset.face_materials[source]);
    ASSERT_EQ(made.face_objects[f], asset.face_objects[source]);
    ASSERT_EQ(made.face_attributes[0].values[f], asset.face_attributes[0].values[source]);
    if (parts.count(static_cast<std::int32_t>(f))) continue;
    ASSERT_TRUE(same_bits(&made.corner_uvs[3 * f], &asset.corner_uvs[3 * f], 3));
    ASSERT_TRUE(same_bits(&made.corner_normals[3 * f], &asset.corner_normals[3 * f], 3));
  }
  for (std::size_t p = 0; p < cut.parts.size(); ++p) {
    const std::size_t f = cut.parts[p], source = cut.face_source[f];
    for (int i = 0; i < 3; ++i) {
      const Vec3& w = cut.part_weights[3 * p + i];
      Vec2 uv = Vec2::Zero();
      Vec3 n = Vec3::Zero();
      for (int k = 0; k < 3; ++k) {
        uv += w[k] * asset.corner_uvs[3 * source + k];
        n += w[k] * asset.corner_normals[3 * source + k];
      }
      ASSERT_LE((made.corner_uvs[3 * f + i] - uv).norm(), 1e-12);
      ASSERT_LE((made.corner_normals[3 * f + i] - n.normalized()).norm(), 1e-12);
    }
  }
  const std::vector<double>& weight = made.vertex_attributes[0].values;
  for (std::size_t v = 0; v < cut.positions.size(); ++v) {
    const Vec3& p = cut.positions[v];
    ASSERT_NEAR(weight[2 * v], p.x() + 2 * p.y() - p.z(), 1e-13 * (1 + size));
  }
  ASSERT_TRUE(same_bits(weight.data(), asset.vertex_attributes[0].values.data(),
                        asset.vertex_attributes[0].values.size()));
}

inline void check_cut(const SurfaceMesh& asset, const CutAsset& cut) {
  check_kept(asset, cut);
  check_parts(asset, cut);
  check_joined(asset, cut);
  check_tips(asset, cut);
}

}  // namespace craze::test
