#include "craze/bake/nearby_cracks.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

#include "craze/bake/segment_distance.h"

namespace craze {

namespace {

/// A segment on its way into a face.
struct Arrival {
  double distance;  ///< at least this far from any point of the face
  std::int32_t face;
  std::int32_t entry;    ///< halfedge of `face` it came in by; −1 at the source
  std::int32_t segment;  ///< index into the pool
};

struct Later {
  bool operator()(const Arrival& x, const Arrival& y) const {
    return std::tie(x.distance, x.face, x.segment) > std::tie(y.distance, y.face, y.segment);
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
  Propagation(const TriangleMesh& mesh, double max_distance)
      : mesh_(mesh),
        max_distance_(max_distance),
        covered_(mesh.face_count(), std::numeric_limits<double>::infinity()),
        last_(mesh.face_count(), -1) {}

  void start(std::int32_t h) {
    pool_.push_back({mesh_.position(mesh_.from(h)), mesh_.position(mesh_.to(h)), h});
    queue_.push({0, TriangleMesh::face_of(h), -1, static_cast<std::int32_t>(pool_.size()) - 1});
  }

  NearbyCracks run() {
    while (!queue_.empty()) {
      const Arrival arrival = queue_.top();
      queue_.pop();
      if (arrival.distance <= covered_[arrival.face] && !is_known(arrival)) accept(arrival);
    }
    return gather();
  }

 private:
  struct Accepted {
    std::int32_t segment;
    std::int32_t previous;  ///< the one accepted before on the same face
  };

  bool is_known(const Arrival& arrival) const {
    const std::int32_t h = pool_[arrival.segment].halfedge;
    for (std::int32_t i = last_[arrival.face]; i >= 0; i = accepted_[i].previous) {
      if (pool_[accepted_[i].segment].halfedge == h) return true;
    }
    return false;
  }

  void accept(const Arrival& arrival) {
    const std::int32_t f = arrival.face;
    const NearbyCrack segment = pool_[arrival.segment];
    accepted_.push_back({arrival.segment, last_[f]});
    last_[f] = static_cast<std::int32_t>(accepted_.size()) - 1;

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
    pool_.push_back({unfold(segment.a), unfold(segment.b), segment.halfedge});
    queue_.push({distance, g, o, static_cast<std::int32_t>(pool_.size()) - 1});
  }

  NearbyCracks gather() const {
    NearbyCracks result;
    result.max_distance = max_distance_;
    result.first.reserve(mesh_.face_count() + 1);
    result.segments.reserve(accepted_.size());
    result.first.push_back(0);
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      for (std::int32_t i = last_[f]; i >= 0; i = accepted_[i].previous) {
        result.segments.push_back(pool_[accepted_[i].segment]);
      }
      // Nearest first.
      std::reverse(result.segments.begin() + result.first.back(), result.segments.end());
      result.first.push_back(static_cast<std::int32_t>(result.segments.size()));
    }
    return result;
  }

  const TriangleMesh& mesh_;
  double max_distance_;
  std::vector<NearbyCrack> pool_;
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

NearbyCracks nearby_cracks(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                           double max_distance) {
  if (sides.empty()) return {max_distance, {}, {}};
  Propagation propagation(mesh, max_distance);
  for (const std::int32_t h : sides) propagation.start(h);
  return propagation.run();
}

}  // namespace craze
