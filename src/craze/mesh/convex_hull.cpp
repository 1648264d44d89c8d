#include "craze/mesh/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace craze {

namespace {

/// Of the points' size: who is less far outside is inside.
constexpr double rounding = 1e-9;

class Hull {
 public:
  explicit Hull(const std::vector<Vec3>& points) : points_(points) {
    Vec3 low = points[0], high = points[0];
    for (const Vec3& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    tiny_ = rounding * (high - low).norm();
  }

  /// False where the points lie in a plane.
  bool begin() {
    const auto farthest = [&](auto&& distance) {
      std::int32_t best = 0;
      double most = -1;
      for (std::size_t i = 0; i < points_.size(); ++i) {
        const double d = distance(points_[i]);
        if (d > most) {
          most = d;
          best = static_cast<std::int32_t>(i);
        }
      }
      return std::pair(best, most);
    };
    const std::int32_t a = farthest([&](const Vec3& p) { return (p - points_[0]).norm(); }).first;
    const Vec3& o = points_[a];
    const auto [b, length] = farthest([&](const Vec3& p) { return (p - o).norm(); });
    if (!(length > tiny_)) return false;
    const Vec3 along = (points_[b] - o) / length;
    const auto [c, width] = farthest([&](const Vec3& p) { return along.cross(p - o).norm(); });
    if (!(width > tiny_)) return false;
    const Vec3 normal = along.cross(points_[c] - o) / width;
    const auto [d, height] = farthest([&](const Vec3& p) { return std::abs(normal.dot(p - o)); });
    if (!(height > tiny_)) return false;
    const bool above = normal.dot(points_[d] - o) > 0;
    const std::array<std::int32_t, 3> base = above ? std::array{a, c, b} : std::array{a, b, c};
    add_face(base[0], base[1], base[2]);
    for (std::size_t i = 0; i < 3; ++i) add_face(base[(i + 1) % 3], base[i], d);
    std::vector<std::int32_t> all;
    for (std::size_t i = 0; i < points_.size(); ++i) all.push_back(static_cast<std::int32_t>(i));
    hand_out(all, 0);
    return true;
  }

  /// Adds the point farthest outside; false where there is none.
  bool grow() {
    std::size_t from = faces_.size();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (!faces_[f].is_there || faces_[f].outside.empty()) continue;
      if (from == faces_.size() || faces_[f].farthest > faces_[from].farthest) from = f;
    }
    if (from == faces_.size()) return false;
    const std::int32_t p = faces_[from].outside.front();
    const std::vector<std::size_t> seen = seen_from(p, from);
    std::map<std::int32_t, std::int32_t> horizon;  // its edges, by where they start
    bool is_simple = true;
    for (const std::size_t f : seen) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t u = faces_[f].corners[i], v = faces_[f].corners[(i + 1) % 3];
        if (is_seen_[face_at_.at({v, u})]) continue;
        is_simple = horizon.emplace(u, v).second && is_simple;
      }
    }
    if (!is_simple || !is_one_loop(horizon)) {
      // Rounding has the last word: the point counts as inside.
      for (const std::size_t f : seen) is_seen_[f] = false;
      std::vector<std::int32_t>& outside = faces_[from].outside;
      outside.erase(outside.begin());
      sort_outside(faces_[from]);
      return true;
    }
    std::vector<std::int32_t> loose;
    for (const std::size_t f : seen) {
      faces_[f].is_there = false;
      loose.insert(loose.end(), faces_[f].outside.begin(), faces_[f].outside.end());
      faces_[f].outside.clear();
    }
    const std::size_t first = faces_.size();
    for (const auto& [u, v] : horizon) add_face(u, v, p);
    loose.erase(std::remove(loose.begin(), loose.end(), p), loose.end());
    hand_out(loose, first);
    return true;
  }

  std::size_t vertex_count() const { return corner_numbers().size(); }

  ConvexHull take() const {
    ConvexHull hull;
    const std::map<std::int32_t, std::int32_t> number = corner_numbers();
    for (const auto& [p, i] : number) hull.positions.push_back(points_[p]);
    for (const Face& face : faces_) {
      if (!face.is_there) continue;
      const auto& c = face.corners;
      hull.triangles.push_back({number.at(c[0]), number.at(c[1]), number.at(c[2])});
    }
    return hull;
  }

 private:
  struct Face {
    std::array<std::int32_t, 3> corners;
    Vec3 normal;
    double offset;
    bool is_there = true;
    std::vector<std::int32_t> outside;  // the farthest first
    double farthest = 0;
  };

  double height(const Face& face, std::int32_t p) const {
    return face.normal.dot(points_[p]) - face.offset;
  }

  void add_face(std::int32_t a, std::int32_t b, std::int32_t c) {
    const Vec3 normal = (points_[b] - points_[a]).cross(points_[c] - points_[a]).stableNormalized();
    for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      face_at_[edge] = faces_.size();
    }
    faces_.push_back({{a, b, c}, normal, normal.dot(points_[a]), true, {}, 0});
    is_seen_.push_back(false);
  }

  /// Each point to the first of the faces from `first` on that it is outside of.
  void hand_out(const std::vector<std::int32_t>& points, std::size_t first) {
    for (const std::int32_t p : points) {
      for (std::size_t f = first; f < faces_.size(); ++f) {
        if (height(faces_[f], p) <= tiny_) continue;
        faces_[f].outside.push_back(p);
        break;
      }
    }
    for (std::size_t f = first; f < faces_.size(); ++f) sort_outside(faces_[f]);
  }

  void sort_outside(Face& face) const {
    if (face.outside.empty()) return;
    auto most = face.outside.begin();
    for (auto p = face.outside.begin(); p != face.outside.end(); ++p) {
      if (height(face, *p) > height(face, *most)) most = p;
    }
    std::iter_swap(face.outside.begin(), most);
    face.farthest = height(face, face.outside.front());
  }

  std::vector<std::size_t> seen_from(std::int32_t p, std::size_t from) {
    std::vector<std::size_t> seen{from};
    is_seen_[from] = true;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const std::array<std::int32_t, 3> corners = faces_[seen[k]].corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t across = face_at_.at({corners[(i + 1) % 3], corners[i]});
        if (is_seen_[across] || height(faces_[across], p) <= tiny_) continue;
        is_seen_[across] = true;
        seen.push_back(across);
      }
    }
    return seen;
  }

  static bool is_one_loop(const std::map<std::int32_t, std::int32_t>& horizon) {
    if (horizon.size() < 3) return false;
    std::size_t length = 0;
    std::int32_t at = horizon.begin()->first;
    do {
      const auto next = horizon.find(at);
      if (next == horizon.end()) return false;
      at = next->second;
      ++length;
    } while (at != horizon.begin()->first && length <= horizon.size());
    return length == horizon.size();
  }

  std::map<std::int32_t, std::int32_t> corner_numbers() const {
    std::map<std::int32_t, std::int32_t> number;
    for (const Face& face : faces_) {
      if (!face.is_there) continue;
      for (const std::int32_t p : face.corners) number[p] = 0;
    }
    std::int32_t count = 0;
    for (auto& [p, i] : number) i = count++;
    return number;
  }

  const std::vector<Vec3>& points_;
  double tiny_ = 0;
  std::vector<Face> faces_;
  std::vector<bool> is_seen_;  // #faces: from the point that is being added
  /// The face of each edge, in its own direction.
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> face_at_;
};

}  // namespace

ConvexHull convex_hull(const std::vector<Vec3>& points, std::size_t most_vertices) {
  if (points.empty()) return {};
  Hull hull(points);
  if (!hull.begin()) return {};
  while (hull.vertex_count() < most_vertices && hull.grow()) {
  }
  return hull.take();
}

}  // namespace craze
