#include "craze/products/maps/seen_cracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

#include "craze/base/segment_distance.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze {

namespace {

constexpr std::int64_t visits_between_polls = 1 << 14;

/// A crack on its way into a face.
struct Arrival {
  double distance;  ///< at least this far from any point of the face
  std::int32_t face;
  std::int32_t slot;  ///< what arrives, in the pool
  std::int64_t number;
};

/// In the plane of the face.
struct Traveller {
  SeenCrack seen;
  std::int32_t entry;  ///< halfedge of the face it came in by; −1 at its own
};

struct Later {
  bool operator()(const Arrival& p, const Arrival& q) const {
    return std::tie(p.distance, p.face, p.number) > std::tie(q.distance, q.face, q.number);
  }
};

Vec3 lifted(const Vec2& p) {
  return {p.x(), p.y(), 0};
}

double distance_to(const Vec2& p, const SeenCrack& seen) {
  return point_segment_distance(lifted(p), lifted(seen.a), lifted(seen.b));
}

class Spread {
 public:
  Spread(const MapSurface& maps, const SightLimits& limits)
      : mesh_(maps.surface.positions, maps.surface.triangles),
        limits_(limits),
        covered_(maps.surface.triangles.size(), std::numeric_limits<double>::infinity()),
        last_(maps.surface.triangles.size(), -1) {
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      planes_.push_back(face_plane(maps.surface, f));
    }
  }

  void start(const MapCrack& crack, std::int32_t index) {
    const FacePlane& plane = planes_[crack.face];
    send(0, crack.face, {{plane.flat(crack.a), plane.flat(crack.b), index}, -1});
  }

  void run(const Context& context) {
    for (std::int64_t n = 0; !queue_.empty(); ++n) {
      if (n % visits_between_polls == 0) {
        context.check();
        context.report({"maps"});
      }
      const Arrival arrival = queue_.top();
      queue_.pop();
      const Traveller traveller = pool_[arrival.slot];
      free_.push_back(arrival.slot);
      const std::int32_t crack = traveller.seen.crack;
      if (matters(arrival.face, arrival.distance, crack) && is_new(arrival.face, crack)) {
        accept(arrival.distance, arrival.face, traveller);
      }
    }
  }

  SeenCracks take() {
    SeenCracks result;
    const auto faces = static_cast<std::size_t>(mesh_.face_count());
    result.first.assign(faces + 1, 0);
    for (const Accepted& a : accepted_) ++result.first[a.face + 1];
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    std::vector<std::int32_t> next(result.first.begin(), result.first.end() - 1);
    result.cracks.resize(accepted_.size());
    for (const Accepted& a : accepted_) result.cracks[next[a.face]++] = a.seen;
    result.farthest = std::move(covered_);
    return result;
  }

 private:
  struct Accepted {
    SeenCrack seen;
    std::int32_t face, previous;  // previous: the one accepted before on the same face
  };

  bool matters(std::int32_t face, double distance, std::int32_t crack) const {
    const double margin = limits_.margin[face];
    return distance - margin <= covered_[face] + margin ||
           distance - margin <= limits_.reach[crack];
  }

  bool is_new(std::int32_t face, std::int32_t crack) const {
    for (std::int32_t i = last_[face]; i >= 0; i = accepted_[i].previous) {
      if (accepted_[i].seen.crack == crack) return false;
    }
    return true;
  }

  void send(double distance, std::int32_t face, const Traveller& traveller) {
    auto slot = static_cast<std::int32_t>(pool_.size());
    if (free_.empty()) {
      pool_.push_back(traveller);
    } else {
      slot = free_.back();
      free_.pop_back();
      pool_[slot] = traveller;
    }
    queue_.push({distance, face, slot, sent_++});
  }

  void accept(double distance, std::int32_t f, const Traveller& traveller) {
    accepted_.push_back({traveller.seen, f, last_[f]});
    last_[f] = static_cast<std::int32_t>(accepted_.size()) - 1;
    // The distance to a segment is convex, so over the face it is largest at a corner.
    double largest = 0;
    for (const Vec2& corner : planes_[f].corners) {
      largest = std::max(largest, distance_to(corner, traveller.seen));
    }
    covered_[f] = std::min(covered_[f], largest);
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      if (h != traveller.entry && !mesh_.is_open(h)) pass_on(distance, traveller.seen, h);
    }
  }

  void pass_on(double least, const SeenCrack& seen, std::int32_t h) {
    const std::int32_t f = TriangleMesh::face_of(h), o = mesh_.opposite(h);
    const std::int32_t g = TriangleMesh::face_of(o);
    if (!matters(g, least, seen.crack) || !is_new(g, seen.crack)) return;
    const Vec2 &from = planes_[f].corners[h % 3], &to = planes_[f].corners[(h + 1) % 3];
    const double distance = std::max(
        least, coplanar_segment_distance(lifted(seen.a), lifted(seen.b), lifted(from), lifted(to)));
    if (!matters(g, distance, seen.crack)) return;
    // The rotation that takes the edge in the plane of f to the same edge in that of g.
    const Vec2 &origin = planes_[g].corners[(o % 3 + 1) % 3], &end = planes_[g].corners[o % 3];
    const Vec2 u = (to - from).stableNormalized(), w = (end - origin).stableNormalized();
    const double c = u.dot(w), s = u.x() * w.y() - u.y() * w.x();
    const auto turn = [&](const Vec2& p) -> Vec2 {
      const Vec2 d = p - from;
      return origin + Vec2(c * d.x() - s * d.y(), s * d.x() + c * d.y());
    };
    send(distance, g, {{turn(seen.a), turn(seen.b), seen.crack}, o});
  }

  TriangleMesh mesh_;
  const SightLimits& limits_;
  std::vector<FacePlane> planes_;
  std::vector<Traveller> pool_;     // of what is on its way
  std::vector<std::int32_t> free_;  // slots of the pool
  std::int64_t sent_ = 0;
  std::vector<Accepted> accepted_;
  std::vector<double> covered_;
  std::vector<std::int32_t> last_;
  std::priority_queue<Arrival, std::vector<Arrival>, Later> queue_;
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
  Spread spread(maps, limits);
  for (std::size_t i = 0; i < maps.cracks.size(); ++i) {
    spread.start(maps.cracks[i], static_cast<std::int32_t>(i));
  }
  spread.run(context);
  return spread.take();
}

}  // namespace craze
