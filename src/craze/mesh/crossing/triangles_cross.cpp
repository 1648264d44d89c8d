#include "craze/mesh/crossing/triangles_cross.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace craze {

namespace {

/// Distances below this part of the triangles' size are rounding.
constexpr double rounding = 1e-9;

/// Six times the volume of a tetrahedron.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// A corner by index or by place; −1: none.
struct SharedCorner {
  int of_s = -1, of_t = -1;
};

/// How many corners they share by index; if one, which.
int shared(const Triangle& s, const Triangle& t, SharedCorner& corner) {
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (s[static_cast<std::size_t>(i)] != t[static_cast<std::size_t>(j)]) continue;
      corner = {i, j};
      ++count;
    }
  }
  return count;
}

class Pair {
 public:
  Pair(const std::vector<Vec3>& positions, const Triangle& s, const Triangle& t)
      : s_{{&positions[s[0]], &positions[s[1]], &positions[s[2]]}},
        t_{{&positions[t[0]], &positions[t[1]], &positions[t[2]]}} {}

  /// How many corners they share; if one, which.
  int shared(SharedCorner& corner) const {
    int count = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (s_.at[i] != t_.at[j] && s_[i] != t_[j]) continue;
        corner = {i, j};
        ++count;
      }
    }
    return count;
  }

  /// Whether a quick look says for certain that they do not cross, with what it calls zero as much
  /// larger than its rounding, or smaller than that of the exact look, as need be.
  bool are_apart(const SharedCorner& corner, bool one_sheet) const {
    if (corner.of_s >= 0) return are_apart_around(corner, one_sheet);
    const Place s = place(s_, t_);
    if (s.is_beside && !one_sheet) return true;
    if (one_sheet && !s.is_off) return false;
    const Place t = place(t_, s_);
    return (s.is_beside || t.is_beside) && (!one_sheet || t.is_off);
  }

  bool edges_pierce(const SharedCorner& corner) {
    return edges_pierce(s_, corner.of_s, t_, corner.of_t) ||
           edges_pierce(t_, corner.of_t, s_, corner.of_s);
  }

  /// In one plane, turned the same way.
  bool overlap() {
    const Vec3 of_s = area_normal(s_), of_t = area_normal(t_);
    if (!(of_s.dot(of_t) > 0)) return false;
    const double s_squared = of_s.squaredNorm(), t_squared = of_t.squaredNorm();
    const bool s_is_larger = s_squared > t_squared;
    const Vec3& of_large = s_is_larger ? of_s : of_t;
    const Corners &large = s_is_larger ? s_ : t_, &small = s_is_larger ? t_ : s_;
    if (are_surely_in_two_planes(of_large, s_is_larger ? s_squared : t_squared, large[0], small)) {
      return false;
    }
    const Vec3 normal = of_large.stableNormalized();
    const double tiny = rounding * size();
    for (const Vec3* p : small.at) {
      if (std::abs(normal.dot(*p - large[0])) > tiny) return false;
    }
    return !edge_parts(s_, t_, normal, tiny) && !edge_parts(t_, s_, normal, tiny);
  }

 private:
  struct Corners {
    const Vec3* at[3];
    const Vec3& operator[](int i) const { return *at[i]; }
  };

  static constexpr double beside = 1e-24;    // of squared volumes; rounding has some 1e-30
  static constexpr double touching = 1e-21;  // of squared volumes; pierces(): at least 1e-20
  static constexpr double in_plane = 16 * rounding * rounding;  // overlap(): at most 2
  static constexpr double sliver = 1e-6;                        // of squared areas

  struct Place {
    bool is_beside;  // on one side of a plane
    bool is_off;     // not all of it in the plane
  };
  /// Where s is of the plane of t.
  static Place place(const Corners& s, const Corners& t) {
    const Vec3 &o = t[0], a = t[1] - o, b = t[2] - o, normal = a.cross(b);
    double least = 0, most = 0, size = a.squaredNorm() + b.squaredNorm();
    for (int i = 0; i < 3; ++i) {
      const Vec3 p = s[i] - o;
      const double above = normal.dot(p);
      least = i == 0 ? above : std::min(least, above);
      most = i == 0 ? above : std::max(most, above);
      size += p.squaredNorm();
    }
    const double nearest = least > 0 ? least : most < 0 ? -most : 0;
    const double farthest = std::max(-least, most);
    return {nearest * nearest > beside * size * size * size,
            farthest * farthest > in_plane * size * normal.squaredNorm()};
  }

  bool are_apart_around(const SharedCorner& corner, bool one_sheet) const {
    const auto& [i, j] = corner;
    const Vec3 &o = s_[i], p = s_[after(i)] - o, q = s_[before(i)] - o;
    const Vec3 a = t_[after(j)] - o, b = t_[before(j)] - o;
    const Vec3 of_s = p.cross(q), of_t = a.cross(b);
    const double p_above = of_t.dot(p), q_above = of_t.dot(q);
    const double a_above = of_s.dot(a), b_above = of_s.dot(b);
    const double pq = std::min(p_above * p_above, q_above * q_above);
    const double ab = std::min(a_above * a_above, b_above * b_above);
    const double size = p.squaredNorm() + q.squaredNorm() + a.squaredNorm() + b.squaredNorm();
    const double volume = size * size * size;
    const bool pq_on_one_side = p_above * q_above > 0, ab_on_one_side = a_above * b_above > 0;
    if (!(pq_on_one_side && pq > beside * volume) && !(ab_on_one_side && ab > beside * volume) &&
        !((pq_on_one_side || pq < touching * volume) &&
          (ab_on_one_side || ab < touching * volume))) {
      return false;
    }
    if (!one_sheet) return true;
    const double s_squared = of_s.squaredNorm(), t_squared = of_t.squaredNorm();
    if (std::max(p_above * p_above, q_above * q_above) > in_plane * size * t_squared &&
        std::max(a_above * a_above, b_above * b_above) > in_plane * size * s_squared) {
      return true;
    }
    // In one plane: whether a line of one through the corner parts them.
    if (!(std::max(s_squared, t_squared) > sliver * size * size)) return false;
    const Vec3& normal = s_squared > t_squared ? of_s : of_t;
    const Vec3 left_of_p = normal.cross(p), left_of_q = normal.cross(q);
    const double pa = left_of_p.dot(a), pb = left_of_p.dot(b);
    const double qa = left_of_q.dot(a), qb = left_of_q.dot(b);
    return (pa <= 0 && pb <= 0) || (qa >= 0 && qb >= 0) || (pa >= 0 && qa >= 0) ||
           (pb <= 0 && qb <= 0);
  }

  static int after(int i) { return i == 2 ? 0 : i + 1; }
  static int before(int i) { return i == 0 ? 2 : i - 1; }

  static Vec3 area_normal(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

  /// The diagonal of the box around both.
  double size() {
    if (size_ < 0) {
      Eigen::AlignedBox3d both;
      for (const Vec3* p : s_.at) both.extend(*p);
      for (const Vec3* p : t_.at) both.extend(*p);
      size_ = both.diagonal().norm();
    }
    return size_;
  }

  /// Whether an edge of `edges`, not one at the shared corner, goes from one side of t to the other
  /// through its inside. Edges opposite a shared corner that meet are one way to it from inside
  /// both triangles.
  bool edges_pierce(const Corners& edges, int shared, const Corners& t, int t_shared) {
    const int last = std::max(t_shared, 0);
    const Vec3 &a = t[(last + 1) % 3], &b = t[(last + 2) % 3], &c = t[last];
    const Vec3 normal = (b - a).cross(c - a);
    double above[3] = {};
    for (int i = 0; i < 3; ++i) {
      if (i != shared) above[i] = normal.dot(edges[i] - a);
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if (i == shared || j == shared) continue;
      if (!((above[i] > 0 && above[j] < 0) || (above[i] < 0 && above[j] > 0))) continue;
      const double tiny = rounding * size() * size() * size();
      if (!(std::abs(above[i]) > tiny && std::abs(above[j]) > tiny)) continue;
      const Vec3 &p = edges[i], &q = edges[j];
      const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
      const double inside = t_shared >= 0 ? -tiny : tiny;
      if ((u > inside && v > tiny && w > tiny) || (u < -inside && v < -tiny && w < -tiny)) {
        return true;
      }
    }
    return false;
  }

  /// What the distances from the plane say for certain, without a root.
  bool are_surely_in_two_planes(const Vec3& normal, double normal_squared, const Vec3& origin,
                                const Corners& t) {
    constexpr double least = 1e-200;  // where products still have all their digits
    double farthest = 0;
    for (const Vec3* p : t.at) farthest = std::max(farthest, std::abs(normal.dot(*p - origin)));
    const double certain = 2 * rounding * size();
    return normal_squared > least && farthest * farthest > certain * certain * normal_squared;
  }

  /// Whether t lies beyond an edge of s.
  static bool edge_parts(const Corners& s, const Corners& t, const Vec3& normal, double tiny) {
    for (int i = 0; i < 3; ++i) {
      const Vec3& from = s[i];
      const Vec3 outwards = (s[(i + 1) % 3] - from).cross(normal).stableNormalized();
      if (std::all_of(t.at, t.at + 3,
                      [&](const Vec3* p) { return outwards.dot(*p - from) >= -tiny; })) {
        return true;
      }
    }
    return false;
  }

  Corners s_, t_;
  double size_ = -1;  // as yet unknown
};

}  // namespace

bool triangles_cross(const std::vector<Vec3>& positions, const Triangle& s, const Triangle& t,
                     bool one_sheet) {
  SharedCorner corner;
  const int by_index = shared(s, t, corner);
  if (by_index >= 2) return false;
  Pair pair(positions, s, t);
  if (pair.are_apart(corner, one_sheet)) return false;  // as two that share more are, too
  const int count = pair.shared(corner);
  if (count >= 2 || (count > by_index && pair.are_apart(corner, one_sheet))) return false;
  return pair.edges_pierce(corner) || (one_sheet && pair.overlap());
}

}  // namespace craze
