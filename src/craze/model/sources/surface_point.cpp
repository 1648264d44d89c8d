#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "craze/base/parallel.h"
#include "craze/error.h"
#include "craze/mesh/closest_point.h"
#include "craze/model/sources/surface_distance.h"

namespace craze {

namespace {

constexpr double farthest_of_diagonal = 0.1;

}  // namespace

PointOnSurface closest_surface_point(const TriangleMesh& mesh, const Vec3& point,
                                     const Context& context) {
  constexpr std::size_t grain = 4096;
  const auto n = static_cast<std::size_t>(mesh.face_count());
  std::vector<PointOnSurface> best((n + grain - 1) / grain);
  parallel_for(context.threads, n, grain, [&](std::size_t begin, std::size_t end) {
    PointOnSurface& mine = best[begin / grain];
    mine.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i < end; ++i) {
      const auto f = static_cast<std::int32_t>(i);
      const Triangle& t = mesh.triangle(f);
      const Vec3 a = mesh.position_near(t[0], point);
      const Vec3 b = mesh.position_near(t[1], a), c = mesh.position_near(t[2], a);
      const Vec3 w = nearest_weights(point, a, b, c);
      const Vec3 q = w[0] * a + w[1] * b + w[2] * c;
      const double d = (q - point).norm();
      if (d < mine.distance) mine = {f, q, d};
    }
  });
  const auto nearest = std::min_element(
      best.begin(), best.end(),
      [](const PointOnSurface& a, const PointOnSurface& b) { return a.distance < b.distance; });
  return nearest == best.end() ? PointOnSurface{} : *nearest;
}

PointOnSurface require_surface_point(const TriangleMesh& mesh, const Vec3& point, const char* where,
                                     const Context& context) {
  PointOnSurface nearest = closest_surface_point(mesh, point, context);
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
