#include "craze/mesh/corner_frames.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "craze/base/elementary.h"

namespace craze {

namespace {

constexpr double smooth_cosine = 0.766;  // of 40 degrees

Vec3 face_normal(const SurfaceMesh& s, std::size_t f) {
  const Triangle& t = s.triangles[f];
  const Vec3& p = s.positions[t[0]];
  return (s.positions[t[1]] - p).cross(s.positions[t[2]] - p).stableNormalized();
}

double angle_between(const Vec3& a, const Vec3& b) {
  return elementary::atan2(a.cross(b).norm(), a.dot(b));
}

/// From corner i of face f to the two others.
std::array<Vec3, 2> sides_at(const SurfaceMesh& s, std::size_t f, int i) {
  const Triangle& t = s.triangles[f];
  const Vec3& p = s.positions[t[i]];
  return {s.positions[t[(i + 1) % 3]] - p, s.positions[t[(i + 2) % 3]] - p};
}

/// The gradient of u in the plane of the face times a positive number; zero where UVs have no area.
Vec3 along_u(const SurfaceMesh& s, std::size_t f, bool mirrored) {
  const auto [d1, d2] = sides_at(s, f, 0);
  const Vec2 t1 = s.corner_uvs[3 * f + 1] - s.corner_uvs[3 * f];
  const Vec2 t2 = s.corner_uvs[3 * f + 2] - s.corner_uvs[3 * f];
  const Vec3 os = t2.y() * d1 - t1.y() * d2;
  return mirrored ? Vec3(-os) : os;
}

Vec3 in_plane(const Vec3& v, const Vec3& n) {
  return (v - v.dot(n) * n).stableNormalized();
}

/// What corners must share to share their tangent, as numbers to sort by.
using Place = std::array<double, 9>;

/// The number of each corner's place.
std::vector<std::int32_t> numbered(const std::vector<Place>& place) {
  std::vector<std::int32_t> order(place.size()), number(place.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t x, std::int32_t y) { return place[x] < place[y]; });
  for (std::size_t i = 0, n = 0; i < order.size(); ++i) {
    if (i > 0 && place[order[i]] != place[order[i - 1]]) ++n;
    number[order[i]] = static_cast<std::int32_t>(n);
  }
  return number;
}

/// The first corner of those that hang together with each one by edges of equal ends.
std::vector<std::int32_t> corner_groups(const std::vector<Place>& place) {
  const std::vector<std::int32_t> number = numbered(place);
  std::vector<std::int32_t> first(place.size());
  std::iota(first.begin(), first.end(), 0);
  const auto root = [&](std::int32_t c) {
    while (first[c] != c) c = first[c] = first[first[c]];
    return c;
  };
  const auto join = [&](std::int32_t c, std::int32_t d) {
    const std::int32_t a = root(c), b = root(d);
    first[std::max(a, b)] = std::min(a, b);
  };
  struct Edge {
    std::array<std::int32_t, 2> ends, corners;  // by number, the smaller first
  };
  std::vector<Edge> edges;
  for (std::size_t c = 0; c < place.size(); ++c) {
    const auto from = static_cast<std::int32_t>(c);
    const std::int32_t to = from % 3 == 2 ? from - 2 : from + 1;
    edges.push_back(number[from] < number[to] ? Edge{{number[from], number[to]}, {from, to}}
                                              : Edge{{number[to], number[from]}, {to, from}});
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& e, const Edge& f) { return e.ends < f.ends; });
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i].ends != edges[i - 1].ends) continue;
    join(edges[i].corners[0], edges[i - 1].corners[0]);
    join(edges[i].corners[1], edges[i - 1].corners[1]);
  }
  for (std::size_t c = 0; c < first.size(); ++c) first[c] = root(static_cast<std::int32_t>(c));
  return first;
}

}  // namespace

std::vector<Vec3> corner_normals(const SurfaceMesh& surface) {
  if (!surface.corner_normals.empty()) return surface.corner_normals;
  const std::size_t faces = surface.triangles.size();
  std::vector<std::vector<std::int32_t>> corners_at(surface.positions.size());
  std::vector<Vec3> flat(faces), normals(3 * faces);
  for (std::size_t f = 0; f < faces; ++f) {
    flat[f] = face_normal(surface, f);
    for (int i = 0; i < 3; ++i) {
      corners_at[surface.triangles[f][i]].push_back(static_cast<std::int32_t>(3 * f + i));
    }
  }
  for (const std::vector<std::int32_t>& corners : corners_at) {
    for (const std::int32_t own : corners) {
      Vec3 sum = Vec3::Zero();
      for (const std::int32_t other : corners) {
        if (flat[own / 3].dot(flat[other / 3]) < smooth_cosine) continue;
        const auto [a, b] = sides_at(surface, other / 3, other % 3);
        sum += angle_between(a, b) * flat[other / 3];
      }
      normals[own] = sum.stableNormalized();
    }
  }
  return normals;
}

CornerTangents corner_tangents(const SurfaceMesh& surface, const std::vector<Vec3>& normals) {
  const std::size_t faces = surface.triangles.size();
  CornerTangents result;
  result.handed.resize(faces);
  result.tangent.assign(3 * faces, Vec3::Zero());
  std::vector<Place> place(3 * faces);
  for (std::size_t f = 0; f < faces; ++f) {
    const Vec2 t1 = surface.corner_uvs[3 * f + 1] - surface.corner_uvs[3 * f];
    const Vec2 t2 = surface.corner_uvs[3 * f + 2] - surface.corner_uvs[3 * f];
    const bool mirrored = t1.x() * t2.y() - t1.y() * t2.x() < 0;
    result.handed[f] = mirrored ? -1 : 1;
    const Vec3 u = along_u(surface, f, mirrored);
    for (int i = 0; i < 3; ++i) {
      const std::size_t c = 3 * f + i;
      const Vec3& p = surface.positions[surface.triangles[f][i]];
      const Vec3& n = normals[c];
      const Vec2& uv = surface.corner_uvs[c];
      place[c] = {p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), uv.x(), uv.y(), mirrored ? -1.0 : 1.0};
      const auto [a, b] = sides_at(surface, f, i);
      result.tangent[c] = angle_between(in_plane(a, n), in_plane(b, n)) * in_plane(u, n);
    }
  }
  const std::vector<std::int32_t> group = corner_groups(place);
  std::vector<Vec3> sum(3 * faces, Vec3::Zero());
  for (std::size_t c = 0; c < group.size(); ++c) sum[group[c]] += result.tangent[c];
  for (std::size_t c = 0; c < group.size(); ++c) {
    result.tangent[c] = in_plane(sum[group[c]], normals[c]);
    if (result.tangent[c].isZero()) result.tangent[c] = normals[c].unitOrthogonal();
  }
  return result;
}

}  // namespace craze
