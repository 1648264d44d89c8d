#include "craze/engine/asset/keep_to_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace craze {

namespace {

constexpr double one_surface = 0.906;     // cosine of 25 degrees
constexpr double least_crossing = 0.5;    // cosine between vector and edge: below, reach shrinks
constexpr double parallel_planes = 0.02;  // sine: such planes have no edge

/// The planes around a vertex; those after the second only say that there are more.
struct Planes {
  std::array<Vec3, 2> sum{Vec3::Zero(), Vec3::Zero()};  // of area normals
  std::int32_t count = 0;
  bool is_fine = false;
};

void add_plane(const Vec3& area_normal, Planes& planes) {
  const Vec3 n = area_normal.normalized();
  for (std::int32_t k = 0; k < std::min(planes.count, 2); ++k) {
    if (n.dot(planes.sum[k].normalized()) > one_surface) {
      planes.sum[k] += area_normal;
      return;
    }
  }
  if (planes.count < 2) planes.sum[planes.count] = area_normal;
  ++planes.count;
}

/// How far along the unit vector `edge` a line across `u`, moved by u, meets it.
double reach_along(const Vec3& edge, const Vec3& u) {
  const double along = edge.dot(u), length = u.norm();
  if (std::abs(along) >= least_crossing * length) return length > 0 ? length * length / along : 0;
  return along / (least_crossing * least_crossing);
}

Vec3 kept(const Planes& planes, const Vec3& u, bool is_rim) {
  const Vec3 n = planes.sum[0].normalized();
  if (planes.count == 1) return u - u.dot(n) * n;
  const Vec3 edge = n.cross(planes.sum[1].normalized());
  if (edge.norm() < parallel_planes) return u - u.dot(n) * n;
  const Vec3 e = edge.normalized();
  return (is_rim ? reach_along(e, u) : e.dot(u)) * e;
}

}  // namespace

void keep_to_planes(const SurfaceMesh& asset, const CutAsset& cut, double fine,
                    std::vector<Vec3>& field) {
  std::vector<Planes> planes(cut.positions.size());
  for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
    const Triangle& source = asset.triangles[cut.face_source[f]];
    const Vec3 &a = asset.positions[source[0]], &b = asset.positions[source[1]],
               &c = asset.positions[source[2]];
    const Vec3 normal = (b - a).cross(c - a);
    const double longest =
        std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    for (const std::int32_t v : cut.triangles[f]) {
      planes[v].is_fine = planes[v].is_fine || longest < fine;
      if (!normal.isZero(0)) add_plane(normal, planes[v]);
    }
  }
  std::vector<char> is_rim(cut.positions.size(), 0);
  for (const CutEdge& edge : cut.edges) {
    for (const std::int32_t h : edge.side) {
      if (h < 0) continue;
      const Triangle& t = cut.triangles[h / 3];
      is_rim[t[h % 3]] = is_rim[t[(h + 1) % 3]] = 1;
    }
  }
  for (std::size_t v = 0; v < field.size(); ++v) {
    if (planes[v].is_fine || planes[v].count == 0) continue;
    field[v] = planes[v].count > 2 ? Vec3(Vec3::Zero()) : kept(planes[v], field[v], is_rim[v] != 0);
  }
}

}  // namespace craze
