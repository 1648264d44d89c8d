#include "craze/model/cutting/vertex_slide.h"

#include <algorithm>
#include <cmath>

namespace craze {

namespace {

// How far off the old surface the vertex may come, in lengths of the edge it slides along.
constexpr double most_deviation = 0.05;
// Least height over longest edge of a face that the slide leaves, unless it was thinner before.
constexpr double least_height = 0.2;

/// Height over the longest edge; 0.87 where all edges are equal.
double thinness(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

bool may_slide(const TriangleMesh& mesh, std::int32_t v, const Vec3& to) {
  const Vec3& p = mesh.position(v);
  bool good = true;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const Vec3 b = mesh.position_near(mesh.to(h), p);
    const Vec3 c = mesh.position_near(mesh.from(TriangleMesh::prev(h)), p);
    const Vec3 before = (b - p).cross(c - p), after = (b - to).cross(c - to);
    const double least = std::min(least_height, thinness(p, b, c));
    good = good && before.dot(after) > 0 && thinness(to, b, c) >= least;
  });
  return good;
}

/// How far `to` is from the faces around v, seen along their normals.
double deviation(const TriangleMesh& mesh, std::int32_t v, const Vec3& to) {
  const Vec3& p = mesh.position(v);
  const Vec3 move = to - p;
  double farthest = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const Vec3 b = mesh.position_near(mesh.to(h), p);
    const Vec3 c = mesh.position_near(mesh.from(TriangleMesh::prev(h)), p);
    const Vec3 normal = (b - p).cross(c - p);
    const double length = normal.norm();
    if (length > 0) farthest = std::max(farthest, std::abs(normal.dot(move)) / length);
  });
  return farthest;
}

}  // namespace

bool slide_vertex(CrackedSheet& sheet, std::int32_t h, double t) {
  const TriangleMesh& mesh = sheet.mesh();
  const std::int32_t v = mesh.from(h), toward = mesh.to(h);
  if (mesh.is_open_vertex(v) || mesh.is_pinned(v)) return false;
  const Vec3 edge = mesh.way(v, toward), to = mesh.position(v) + t * edge;
  if (deviation(mesh, v, to) > most_deviation * edge.norm() || !may_slide(mesh, v, to))
    return false;
  sheet.slide(h, t);
  return true;
}

}  // namespace craze
