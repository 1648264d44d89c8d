#include "craze/engine/place_impacts.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/sources/surface_distance.h"

namespace craze {

namespace {

using Box = Eigen::AlignedBox3d;

// What a line through an edge may miss both of its triangles by, in barycentric coordinates.
constexpr double rounding = 1e-9;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Where the line meets the triangle, as a multiple of `direction`; infinite where it does not.
double hit_at(const Vec3& start, const Vec3& direction, const Vec3& a, const Vec3& b,
              const Vec3& c) {
  // Möller, Trumbore: Fast, minimum storage ray/triangle intersection, 1997.
  constexpr double never = std::numeric_limits<double>::infinity();
  const Vec3 ab = b - a, ac = c - a, p = direction.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0) return never;
  const Vec3 from = start - a, q = from.cross(ab);
  const double u = from.dot(p) / determinant, v = direction.dot(q) / determinant;
  if (!(u >= -rounding && v >= -rounding && u + v <= 1 + rounding)) return never;
  return ac.dot(q) / determinant;
}

Vec3 by_direction(const SurfaceMesh& surface, const Vec3& direction) {
  Box box;
  for (const Vec3& p : surface.positions) box.extend(p);
  const Vec3 along = direction.stableNormalized();
  // Outside, whatever the direction: half a diagonal and more from the middle.
  const Vec3 start = box.center() - box.diagonal().norm() * along;
  double first = std::numeric_limits<double>::infinity();
  for (const Triangle& t : surface.triangles) {
    first = std::min(first, hit_at(start, along, surface.positions[t[0]], surface.positions[t[1]],
                                   surface.positions[t[2]]));
  }
  if (std::isfinite(first)) return start + first * along;
  double reach = std::numeric_limits<double>::infinity();  // from the middle to the box's wall
  for (int k = 0; k < 3; ++k) {
    if (along[k] != 0) reach = std::min(reach, 0.5 * box.sizes()[k] / std::abs(along[k]));
  }
  return box.center() - reach * along;
}

Vec3 by_uv(const SurfaceMesh& surface, const Vec2& uv, const std::string& where) {
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorKind::request, "no such place", where, why);
  };
  if (surface.corner_uvs.empty()) fail("the input has no texture coordinates (UVs)");
  Eigen::AlignedBox2d all;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const Vec2 *corner = &surface.corner_uvs[3 * f], &a = corner[0];
    for (int i = 0; i < 3; ++i) all.extend(corner[i]);
    const double area = cross(corner[1] - a, corner[2] - a);
    const double v = cross(uv - a, corner[2] - a) / area;
    const double w = cross(corner[1] - a, uv - a) / area;
    if (!(v >= -rounding && w >= -rounding && v + w <= 1 + rounding)) continue;  // nor where NaN
    const Triangle& t = surface.triangles[f];
    return (1 - v - w) * surface.positions[t[0]] + v * surface.positions[t[1]] +
           w * surface.positions[t[2]];
  }
  fail(
      fmt::format("UV ({:.6g}, {:.6g}) lies on no triangle; all are in ({:.6g}, {:.6g}) to "
                  "({:.6g}, {:.6g})",
                  uv.x(), uv.y(), all.min().x(), all.min().y(), all.max().x(), all.max().y()));
  return {};
}

}  // namespace

std::vector<Impact> place_impacts(std::vector<Impact> impacts, const SurfaceMesh& surface,
                                  const Context& context, const Period& period) {
  if (impacts.empty()) return impacts;
  const TriangleMesh mesh(surface.positions, surface.triangles, period);
  const double diagonal = bounding_diagonal(surface.positions, period);
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    context.check();
    Impact& impact = impacts[i];
    const std::string where = fmt::format("impact {}", i + 1);
    if (impact.relative_radius > 0) impact.radius = impact.relative_radius * diagonal;
    if (!impact.uv.empty()) {
      impact.point = by_uv(surface, {impact.uv[0], impact.uv[1]}, where);
    } else if (!impact.direction.isZero(0)) {
      const Vec3 aim = by_direction(surface, impact.direction);
      impact.point = closest_surface_point(mesh, aim, context).position;
    } else {
      impact.point = require_surface_point(mesh, impact.point, where.c_str(), context).position;
    }
    impact.direction = Vec3::Zero();
    impact.uv.clear();
    impact.relative_radius = 0;
  }
  return impacts;
}

}  // namespace craze
