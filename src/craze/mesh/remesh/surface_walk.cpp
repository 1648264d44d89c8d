#include "craze/mesh/remesh/surface_walk.h"

#include <cmath>
#include <limits>

namespace craze {

namespace {

constexpr int longest_walk = 32;  // steps

}  // namespace

ClosestPoint::Hit SurfaceWalk::walk(const Vec3& point, const ClosestPoint::Filter& filter) const {
  // Its distance is squared until the end.
  ClosestPoint::Hit best{-1, Vec3::Zero(), point, std::numeric_limits<double>::infinity()};
  if (filter.hint < 0 || !tree_.accepts(filter.hint, filter)) return best;
  tree_.improve(best, filter.hint, point);
  const double enough = filter.enough * filter.enough;
  for (int step = 0; step < longest_walk && best.distance > enough; ++step) {
    const std::int32_t from = best.face;
    const Vec3 weights = best.weights;
    const auto look_at = [&](std::int32_t f) {
      if (f != from && tree_.accepts(f, filter)) tree_.improve(best, f, point);
    };
    // Only over the side or the corner on which the point lies can it come nearer.
    for (std::int32_t i = 0; i < 3; ++i) {
      const std::int32_t side = 3 * from + i;
      if (weights[i] == 1) {
        surface_.for_each_outgoing(surface_.from(side),
                                   [&](std::int32_t h) { look_at(TriangleMesh::face_of(h)); });
      } else if (weights[(i + 2) % 3] == 0 && !surface_.is_open(side)) {
        look_at(TriangleMesh::face_of(surface_.opposite(side)));
      }
    }
    if (best.face == from) break;
  }
  best.distance = std::sqrt(best.distance);
  return best;
}

ClosestPoint::Hit SurfaceWalk::find(const Vec3& point, const ClosestPoint::Filter& filter,
                                    double trusted) const {
  ClosestPoint::Hit hit = walk(point, filter);
  if (hit.distance <= trusted) return hit;
  ClosestPoint::Filter from_there = filter;
  if (hit.face >= 0) from_there.hint = hit.face;
  return tree_.find(point, from_there);
}

}  // namespace craze
