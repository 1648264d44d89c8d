#include "craze/products/distance/nearby_cracks.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

#include "craze/base/segment_distance.h"
#include "craze/mesh/components.h"

namespace craze {

namespace {

constexpr std::int64_t visits_between_polls = 1 << 14;

/// A segment on its way into a face.
struct Arrival {
  double distance;  ///< at least this far from any point of the face
  std::int32_t face;
  std::int32_t entry;    ///< halfedge of `face` it came in by; −1 at the source
  std::int64_t number;   ///< of arrivals, in the order in which they were sent
  std::int32_t segment;  ///< index into the pool
};

struct Later {
  bool operator()(const Arrival& x, const Arrival& y) const {
    return std::tie(x.distance, x.face, x.number) > std::tie(y.distance, y.face, y.number);
  }
};

/// Unit vector in the plane of the face of h, perpendicular to h and pointing into the face.
Vec3 into_face(const TriangleMesh& mesh, std::int32_t h, const Vec3& along) {
  const Vec3 side = mesh.position(mesh.from(TriangleMesh::prev(h))) - mesh.position(mesh.from(h));
  const Vec3 across = side - side.dot(along) * along;
  const double length = across.norm();
  return length > 1e-12 * side.norm() ? Vec3(across / length) : Vec3(along.unitOrthogonal());
}

class Propagation {
 public:
  Propagation(const TriangleMesh& mesh, double max_distance, const CrackVisit& visit)
      : mesh_(mesh),
        max_distance_(max_distance),
        visit_(visit),
        covered_(mesh.face_count(), std::numeric_limits<double>::infinity()),
        last_(mesh.face_count(), -1) {}

  void start(std::int32_t h) {
    const NearbyCrack source{mesh_.position(mesh_.from(h)), mesh_.position(mesh_.to(h)), h};
    send(0, TriangleMesh::face_of(h), -1, source);
  }

  /// Until nothing is on its way any more. No face that was visited may be reached again.
  void run(const Context& context) {
    for (std::int64_t n = 0; !queue_.empty(); ++n) {
      if (n % visits_between_polls == 0) {
        context.check();
        context.report({"distance"});
      }
      const Arrival arrival = queue_.top();
      queue_.pop();
      const NearbyCrack segment = pool_[arrival.segment];
      free_.push_back(arrival.segment);
      if (arrival.distance <= covered_[arrival.face] && !is_known(arrival.face, segment.halfedge)) {
        accept(arrival, segment);
      }
    }
    accepted_.clear();
  }

 private:
  struct Accepted {
    std::int32_t halfedge;  ///< of the crack
    std::int32_t previous;  ///< the one accepted before on the same face
  };

  void send(double distance, std::int32_t face, std::int32_t entry, const NearbyCrack& segment) {
    auto slot = static_cast<std::int32_t>(pool_.size());
    if (free_.empty()) {
      pool_.push_back(segment);
    } else {
      slot = free_.back();
      free_.pop_back();
      pool_[slot] = segment;
    }
    queue_.push({distance, face, entry, sent_++, slot});
  }

  bool is_known(std::int32_t face, std::int32_t halfedge) const {
    for (std::int32_t i = last_[face]; i >= 0; i = accepted_[i].previous) {
      if (accepted_[i].halfedge == halfedge) return true;
    }
    return false;
  }

  void accept(const Arrival& arrival, const NearbyCrack& segment) {
    const std::int32_t f = arrival.face;
    accepted_.push_back({segment.halfedge, last_[f]});
    last_[f] = static_cast<std::int32_t>(accepted_.size()) - 1;
    visit_(f, segment);

    // The distance to a segment is convex, so over the face it is largest at a corner.
    double largest = 0;
    for (const std::int32_t v : mesh_.triangle(f)) {
      largest = std::max(largest, point_segment_distance(mesh_.position(v), segment.a, segment.b));
    }
    covered_[f] = std::min(covered_[f], largest);
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      if (h != arrival.entry && !mesh_.is_open(h)) pass_on(arrival, segment, h);
    }
  }

  void pass_on(const Arrival& arrival, const NearbyCrack& segment, std::int32_t h) {
    const Vec3& origin = mesh_.position(mesh_.from(h));
    const Vec3& end = mesh_.position(mesh_.to(h));
    const double distance =
        std::max(arrival.distance, coplanar_segment_distance(segment.a, segment.b, origin, end));
    const std::int32_t o = mesh_.opposite(h), g = TriangleMesh::face_of(o);
    if (distance > max_distance_ || distance > covered_[g]) return;

    const Vec3 along = (end - origin).normalized();
    const Vec3 in = into_face(mesh_, h, along), out = -into_face(mesh_, o, -along);
    const auto unfold = [&](const Vec3& p) -> Vec3 {
      const Vec3 d = p - origin;
      return origin + d.dot(along) * along + d.dot(in) * out;
    };
    send(distance, g, o, {unfold(segment.a), unfold(segment.b), segment.halfedge});
  }

  const TriangleMesh& mesh_;
  double max_distance_;
  const CrackVisit& visit_;
  std::vector<NearbyCrack> pool_;   // of what is on its way
  std::vector<std::int32_t> free_;  // slots of the pool
  std::int64_t sent_ = 0;
  std::vector<Accepted> accepted_;
  std::vector<double> covered_;     // per face: no point of it is farther from a crack than this
  std::vector<std::int32_t> last_;  // per face: index into accepted_
  std::priority_queue<Arrival, std::vector<Arrival>, Later> queue_;
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
  // Cracks stay in their part of the mesh, so one part after the other, each in a stretch of memory
  // that the caches hold, comes to the same.
  const Components parts = find_components(mesh);
  std::vector<std::int32_t> order = sides;
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t g, std::int32_t h) {
    return parts.face[g / 3] < parts.face[h / 3];
  });
  Propagation propagation(mesh, max_distance, visit);
  for (std::size_t i = 0; i < order.size(); ++i) {
    propagation.start(order[i]);
    const bool last = i + 1 == order.size();
    if (last || parts.face[order[i] / 3] != parts.face[order[i + 1] / 3]) propagation.run(context);
  }
}

NearbyCracks nearby_cracks(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                           double max_distance, const Context& context) {
  NearbyCracks result{max_distance, {}, {}};
  if (sides.empty()) return result;
  std::vector<std::int32_t> face_of;
  std::vector<NearbyCrack> found;
  carry_cracks(mesh, sides, max_distance, context,
               [&](std::int32_t face, const NearbyCrack& segment) {
                 face_of.push_back(face);
                 found.push_back(segment);
               });
  // Sorted by face; of one face they stay in order, the nearest first.
  result.first.assign(mesh.face_count() + 1, 0);
  for (const std::int32_t f : face_of) ++result.first[f + 1];
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  std::vector<std::int32_t> next(result.first.begin(), result.first.end() - 1);
  result.segments.resize(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) result.segments[next[face_of[i]]++] = found[i];
  return result;
}

}  // namespace craze
