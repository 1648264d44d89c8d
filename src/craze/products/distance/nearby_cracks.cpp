#include "craze/products/distance/nearby_cracks.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <limits>

#include "craze/base/parallel.h"
#include "craze/base/segment_distance.h"
#include "craze/mesh/components.h"
#include "craze/products/distance/face_spread.h"

namespace craze {

namespace {

// Of each worker, between two looks at the context: some milliseconds.
constexpr std::int64_t visits_between_polls = 1 << 13;

/// Unit vector in the plane of the face of h, perpendicular to h and pointing into the face.
Vec3 into_face(const TriangleMesh& mesh, std::int32_t h, const Vec3& along) {
  const Vec3 side = mesh.position(mesh.from(TriangleMesh::prev(h))) - mesh.position(mesh.from(h));
  const Vec3 across = side - side.dot(along) * along;
  const double length = across.norm();
  return length > 1e-12 * side.norm() ? Vec3(across / length) : Vec3(along.unitOrthogonal());
}

/// Of each corner of a face, the point of the cracks it has taken that is nearest to it.
using NearestPoints = std::array<Vec3, 3>;

NearestPoints none() {
  const Vec3 nowhere = Vec3::Constant(std::numeric_limits<double>::infinity());
  return {nowhere, nowhere, nowhere};
}

/// How crack edges go over the faces in space.
class Propagation {
 public:
  using Carried = NearbyCrack;

  /// `slots` (#F), −1: touched for faces that cracks reach.
  Propagation(const TriangleMesh& mesh, double max_distance, const CrackVisit& visit, int worker,
              std::vector<std::int32_t>& slots)
      : mesh_(mesh), max_distance_(max_distance), visit_(visit), worker_(worker), slots_(slots) {}

  /// No face that has been reached will be again.
  void begin_part() { nearest_.clear(); }

  NearbyCrack source(std::int32_t h) const {
    return {mesh_.position(mesh_.from(h)), mesh_.position(mesh_.to(h)), h};
  }

  std::int32_t number(const NearbyCrack& crack) const { return crack.halfedge; }

  bool matters(std::int32_t, double distance, double covered, const NearbyCrack&) const {
    return distance <= max_distance_ && distance <= covered;
  }

  /// Whether one point of other cracks is nearer than this one to all of the edge, and so to all
  /// beyond it. The square of the distance to a point, less that to a segment, is the largest of
  /// linear functions, one for each point of the segment: less than zero at both ends of the edge,
  /// it is so between them.
  bool is_hidden(std::int32_t h, const NearbyCrack& crack) const {
    constexpr double surely = 1 - 1e-9;
    const std::int32_t slot = slots_[h / 3];
    if (slot < 0) return false;
    const Vec3 &from = mesh_.position(mesh_.from(h)), &to = mesh_.position(mesh_.to(h));
    const double at_from = surely * squared_point_segment_distance(from, crack.a, crack.b);
    const double at_to = surely * squared_point_segment_distance(to, crack.a, crack.b);
    const NearestPoints& nearest = nearest_[slot];
    return std::any_of(nearest.begin(), nearest.end(), [&](const Vec3& p) {
      return (p - from).squaredNorm() < at_from && (p - to).squaredNorm() < at_to;
    });
  }

  double distance_to_edge(std::int32_t h, const NearbyCrack& crack) const {
    return coplanar_segment_distance(crack.a, crack.b, mesh_.position(mesh_.from(h)),
                                     mesh_.position(mesh_.to(h)));
  }

  NearbyCrack across(std::int32_t h, const NearbyCrack& crack) const {
    const Vec3& origin = mesh_.position(mesh_.from(h));
    const Vec3 along = (mesh_.position(mesh_.to(h)) - origin).normalized();
    const Vec3 in = into_face(mesh_, h, along), out = -into_face(mesh_, mesh_.opposite(h), -along);
    const auto unfold = [&](const Vec3& p) -> Vec3 {
      const Vec3 d = p - origin;
      return origin + d.dot(along) * along + d.dot(in) * out;
    };
    return {unfold(crack.a), unfold(crack.b), crack.halfedge};
  }

  double accept(std::int32_t face, const NearbyCrack& crack) {
    const Triangle& t = mesh_.triangle(face);
    std::int32_t& slot = slots_[face];
    if (slot < 0) {
      slot = static_cast<std::int32_t>(nearest_.size());
      nearest_.push_back(none());
    }
    CornerDistances distances;
    for (int i = 0; i < 3; ++i) {
      const Vec3& corner = mesh_.position(t[i]);
      const Vec3 point = nearest_point(corner, crack.a, crack.b);
      distances[i] = (point - corner).norm();
      Vec3& nearest = nearest_[slot][i];
      if (distances[i] < (nearest - corner).norm()) nearest = point;
    }
    visit_(worker_, face, crack, distances);
    // The distance to a segment is convex, so over the face it is largest at a corner.
    return std::max({distances[0], distances[1], distances[2]});
  }

 private:
  const TriangleMesh& mesh_;
  double max_distance_;
  const CrackVisit& visit_;
  int worker_;
  std::vector<std::int32_t>& slots_;    // of faces, in nearest_
  std::vector<NearestPoints> nearest_;  // of the faces of a part
};

/// The sides of cracks, those of one part of the mesh together: part p has [first[p], first[p+1]).
struct SidesByPart {
  std::vector<std::int32_t> sides;
  std::vector<std::size_t> first;

  std::size_t count() const { return first.size() - 1; }
};

SidesByPart by_part(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides) {
  const std::vector<std::int32_t> part = find_components(mesh).face;
  SidesByPart result{sides, {}};
  std::stable_sort(result.sides.begin(), result.sides.end(),
                   [&](std::int32_t g, std::int32_t h) { return part[g / 3] < part[h / 3]; });
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || part[result.sides[i] / 3] != part[result.sides[i - 1] / 3])
      result.first.push_back(i);
  }
  result.first.push_back(sides.size());
  return result;
}

/// Carries cracks over one part of the mesh after the other, each in a stretch of memory that the
/// caches hold.
class PartWorker {
 public:
  PartWorker(const TriangleMesh& mesh, const Propagation& propagation,
             std::vector<FaceCover>& covers)
      : propagation_(propagation), spread_(mesh, propagation_, covers) {}
  PartWorker(const PartWorker&) = delete;
  PartWorker& operator=(const PartWorker&) = delete;

  /// So many visits; parts are taken from `next` on. Returns whether none is left.
  bool work(const SidesByPart& parts, std::atomic<std::size_t>& next, std::int64_t visits) {
    while (spread_.run(visits)) {
      const std::size_t part = next++;
      if (part >= parts.count()) return true;
      propagation_.begin_part();
      for (std::size_t i = parts.first[part]; i < parts.first[part + 1]; ++i)
        spread_.start(parts.sides[i] / 3, propagation_.source(parts.sides[i]));
    }
    return false;
  }

 private:
  Propagation propagation_;
  FaceSpread<Propagation> spread_;
};

}  // namespace

std::vector<std::int32_t> crack_sides(const TriangleMesh& mesh) {
  std::vector<std::int32_t> sides;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.crack_of(h) >= 0) sides.push_back(h);
  }
  return sides;
}

void carry_cracks(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                  double max_distance, const Context& context, const CrackVisit& visit) {
  if (sides.empty()) return;
  const SidesByPart parts = by_part(mesh, sides);
  std::vector<FaceCover> covers(mesh.face_count());
  std::vector<std::int32_t> slots(mesh.face_count(), -1);
  const int count = context.threads.count();
  std::deque<PartWorker> workers;
  for (int i = 0; i < count; ++i)
    workers.emplace_back(mesh, Propagation(mesh, max_distance, visit, i, slots), covers);
  std::vector<char> done(count, 0);
  std::atomic<std::size_t> next = 0;
  const auto work = [&](std::size_t i, std::size_t) {
    done[i] = done[i] || workers[i].work(parts, next, visits_between_polls);
  };
  do {
    context.check();
    const double begun = static_cast<double>(std::min(next.load(), parts.count()));
    context.report({"distance", begun / static_cast<double>(parts.count())});
    parallel_for(context.threads, workers.size(), 1, work);
  } while (std::count(done.begin(), done.end(), 0) > 0);
  context.report({"distance", 1});
}

NearbyCracks nearby_cracks(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                           double max_distance, const Context& context) {
  NearbyCracks result{max_distance, {}, {}};
  if (sides.empty()) return result;
  std::vector<AcceptedByFaces<NearbyCrack>> seen(context.threads.count());
  carry_cracks(mesh, sides, max_distance, context,
               [&](int worker, std::int32_t face, const NearbyCrack& crack,
                   const CornerDistances&) { seen[worker].add(face, crack); });
  sort_by_face<NearbyCrack>(seen, mesh.face_count(), result.first, result.segments);
  return result;
}

}  // namespace craze
