#include "craze/render/smooth_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace craze::render {

namespace {

Vec3 unit_or_zero(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

/// Vertices by group of equal position.
std::vector<std::int32_t> weld(const std::vector<Vec3>& positions) {
  const auto key = [&](std::int32_t v) {
    return std::make_tuple(positions[v].x(), positions[v].y(), positions[v].z());
  };
  std::vector<std::int32_t> order(positions.size()), group(positions.size(), 0);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < order.size(); ++i) {
    group[order[i]] = group[order[i - 1]] + (key(order[i]) != key(order[i - 1]) ? 1 : 0);
  }
  return group;
}

}  // namespace

std::vector<Vec3f> smooth_normals(const SurfaceMesh& mesh, double crease) {
  const std::size_t corners = 3 * mesh.triangles.size();
  std::vector<Vec3> face_normal(mesh.triangles.size()), weighted(corners);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    face_normal[f] = unit_or_zero((b - a).cross(c - a));
    for (int i = 0; i < 3; ++i) {
      const Vec3 &p = mesh.positions[t[i]], &q = mesh.positions[t[(i + 1) % 3]],
                 &r = mesh.positions[t[(i + 2) % 3]];
      const double angle = std::atan2((q - p).cross(r - p).norm(), (q - p).dot(r - p));
      weighted[3 * f + i] = angle * face_normal[f];
    }
  }

  // Corners by welded vertex (counting sort).
  const std::vector<std::int32_t> group = weld(mesh.positions);
  std::vector<std::int32_t> first(mesh.positions.size() + 1, 0), around(corners);
  const auto group_of = [&](std::size_t c) { return group[mesh.triangles[c / 3][c % 3]]; };
  for (std::size_t c = 0; c < corners; ++c) ++first[group_of(c) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::int32_t> fill(first.begin(), first.end() - 1);
  for (std::size_t c = 0; c < corners; ++c) {
    around[fill[group_of(c)]++] = static_cast<std::int32_t>(c);
  }

  const double limit = std::cos(crease * std::numbers::pi / 180);
  std::vector<Vec3f> normals(corners);
  for (std::size_t c = 0; c < corners; ++c) {
    const Vec3& own = face_normal[c / 3];
    Vec3 sum = weighted[c];
    for (std::int32_t i = first[group_of(c)]; i < first[group_of(c) + 1]; ++i) {
      const std::int32_t other = around[i];
      if (other != static_cast<std::int32_t>(c) && own.dot(face_normal[other / 3]) >= limit) {
        sum += weighted[other];
      }
    }
    normals[c] = unit_or_zero(sum).cast<float>();
  }
  return normals;
}

}  // namespace craze::render
