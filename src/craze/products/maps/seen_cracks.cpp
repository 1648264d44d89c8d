#include "craze/products/maps/seen_cracks.h"

#include <algorithm>

#include "craze/base/segment_distance.h"
#include "craze/products/distance/face_spread.h"

namespace craze {

namespace {

constexpr std::int64_t visits_between_polls = 1 << 14;

Vec3 lifted(const Vec2& p) {
  return {p.x(), p.y(), 0};
}

double distance_to(const Vec2& p, const SeenCrack& seen) {
  return point_segment_distance(lifted(p), lifted(seen.a), lifted(seen.b));
}

/// How cracks go from the plane of one face into that of the next.
class Sight {
 public:
  using Carried = SeenCrack;

  Sight(const SurfaceMesh& surface, const TriangleMesh& mesh, const SightLimits& limits)
      : mesh_(mesh), limits_(limits) {
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) planes_.push_back(face_plane(surface, f));
  }

  SeenCrack seen_from_own_face(const MapCrack& crack, std::int32_t index) const {
    const FacePlane& plane = planes_[crack.face];
    return {plane.flat(crack.a), plane.flat(crack.b), index};
  }

  std::int32_t number(const SeenCrack& seen) const { return seen.crack; }

  bool matters(std::int32_t face, double distance, double covered, const SeenCrack& seen) const {
    const double margin = limits_.margin[face];
    return distance - margin <= covered + margin || distance - margin <= limits_.reach[seen.crack];
  }

  // Within its reach a crack is of use behind others too.
  bool is_hidden(std::int32_t, const SeenCrack&) const { return false; }

  double distance_to_edge(std::int32_t h, const SeenCrack& seen) const {
    return coplanar_segment_distance(lifted(seen.a), lifted(seen.b), lifted(from(h)),
                                     lifted(to(h)));
  }

  /// By the rotation that takes the edge in the one plane to the same edge in the other.
  SeenCrack across(std::int32_t h, const SeenCrack& seen) const {
    const std::int32_t o = mesh_.opposite(h);
    const Vec2 &start = from(h), &origin = to(o);
    const Vec2 u = (to(h) - start).stableNormalized(), w = (from(o) - origin).stableNormalized();
    const double c = u.dot(w), s = u.x() * w.y() - u.y() * w.x();
    const auto turn = [&](const Vec2& p) -> Vec2 {
      const Vec2 d = p - start;
      return origin + Vec2(c * d.x() - s * d.y(), s * d.x() + c * d.y());
    };
    return {turn(seen.a), turn(seen.b), seen.crack};
  }

  double accept(std::int32_t face, const SeenCrack& seen) {
    accepted.add(face, seen);
    // The distance to a segment is convex, so over the face it is largest at a corner.
    double largest = 0;
    for (const Vec2& corner : planes_[face].corners) {
      largest = std::max(largest, distance_to(corner, seen));
    }
    return largest;
  }

  AcceptedByFaces<SeenCrack> accepted;

 private:
  const Vec2& from(std::int32_t h) const { return planes_[h / 3].corners[h % 3]; }
  const Vec2& to(std::int32_t h) const { return planes_[h / 3].corners[(h + 1) % 3]; }

  const TriangleMesh& mesh_;
  const SightLimits& limits_;
  std::vector<FacePlane> planes_;
};

}  // namespace

FacePlane face_plane(const SurfaceMesh& surface, std::int32_t f) {
  const Triangle& t = surface.triangles[f];
  FacePlane plane;
  plane.origin = surface.positions[t[0]];
  const Vec3 d1 = surface.positions[t[1]] - plane.origin,
             d2 = surface.positions[t[2]] - plane.origin;
  plane.x = d1.stableNormalized();
  plane.y = d1.cross(d2).stableNormalized().cross(plane.x);
  plane.corners = {Vec2::Zero(), Vec2(d1.norm(), 0), plane.flat(surface.positions[t[2]])};
  return plane;
}

SeenCracks seen_cracks(const MapSurface& maps, const SightLimits& limits, const Context& context) {
  const TriangleMesh mesh(maps.surface.positions, maps.neighbours());
  Sight sight(maps.surface, mesh, limits);
  std::vector<FaceCover> covers(mesh.face_count());
  FaceSpread spread(mesh, sight, covers);
  for (std::size_t i = 0; i < maps.cracks.size(); ++i) {
    const auto index = static_cast<std::int32_t>(i);
    spread.start(maps.cracks[i].face, sight.seen_from_own_face(maps.cracks[i], index));
  }
  for (std::int64_t left = 0; !spread.run(left); left = visits_between_polls) {
    context.check();
    context.report({"maps"});
  }
  SeenCracks seen;
  for (const FaceCover& cover : covers) seen.farthest.push_back(cover.covered);
  sort_by_face<SeenCrack>({&sight.accepted, 1}, mesh.face_count(), seen.first, seen.cracks);
  return seen;
}

}  // namespace craze
