#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "craze/base/parallel.h"
#include "craze/error.h"
#include "craze/model/sources/surface_distance.h"

namespace craze {

namespace {

constexpr double farthest_of_diagonal = 0.1;

// Ericson, Real-Time Collision Detection, 5.1.5: the Voronoi regions of corners, sides, inside.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

}  // namespace

SurfacePoint closest_surface_point(const TriangleMesh& mesh, const Vec3& point,
                                   const Context& context) {
  constexpr std::size_t grain = 4096;
  const auto n = static_cast<std::size_t>(mesh.face_count());
  std::vector<SurfacePoint> best((n + grain - 1) / grain);
  parallel_for(context.threads, n, grain, [&](std::size_t begin, std::size_t end) {
    SurfacePoint& mine = best[begin / grain];
    mine.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i < end; ++i) {
      const auto f = static_cast<std::int32_t>(i);
      const Triangle& t = mesh.triangle(f);
      const Vec3 a = mesh.position_near(t[0], point);
      const Vec3 q =
          closest_on_triangle(point, a, mesh.position_near(t[1], a), mesh.position_near(t[2], a));
      const double d = (q - point).norm();
      if (d < mine.distance) mine = {f, q, d};
    }
  });
  const auto nearest = std::min_element(
      best.begin(), best.end(),
      [](const SurfacePoint& a, const SurfacePoint& b) { return a.distance < b.distance; });
  return nearest == best.end() ? SurfacePoint{} : *nearest;
}

SurfacePoint require_surface_point(const TriangleMesh& mesh, const Vec3& point, const char* where,
                                   const Context& context) {
  SurfacePoint nearest = closest_surface_point(mesh, point, context);
  if (nearest.face < 0) {
    throw Error(ErrorKind::request, "point is not on the surface", where,
                mesh.face_count() == 0 ? "the mesh is empty" : "it is not finite");
  }
  Vec3 low = mesh.position(0), high = low;
  for (const Vec3& p : mesh.positions()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double limit = farthest_of_diagonal * (high - low).norm();
  if (nearest.distance <= limit) return nearest;
  std::ostringstream why;
  why << "(" << point.transpose() << ") is " << nearest.distance
      << " away from the surface, more than a tenth of the mesh's diagonal (" << limit
      << "); the nearest point of the surface is (" << nearest.position.transpose() << ")";
  throw Error(ErrorKind::request, "point is not on the surface", where, why.str());
}

}  // namespace craze
