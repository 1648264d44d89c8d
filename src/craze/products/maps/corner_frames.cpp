#include "craze/products/maps/corner_frames.h"

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
  std::vector<std::int32_t> order(3 * faces);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t x, std::int32_t y) { return place[x] < place[y]; });
  for (std::size_t i = 0; i < order.size();) {
    std::size_t j = i;
    Vec3 sum = Vec3::Zero();
    while (j < order.size() && place[order[j]] == place[order[i]]) {
      sum += result.tangent[order[j++]];
    }
    const Vec3& n = normals[order[i]];
    Vec3 tangent = in_plane(sum, n);
    if (tangent.isZero()) tangent = n.unitOrthogonal();
    for (; i < j; ++i) result.tangent[order[i]] = tangent;
  }
  return result;
}

}  // namespace craze
