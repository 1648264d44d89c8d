// Ear clipping: G. H. Meisters, "Polygons have ears", American Mathematical Monthly 82(6), 1975.
// Clipping an ear changes only its two neighbours (J. O'Rourke, Computational Geometry in C, 1998,
// section 1.4), so each corner is looked at a bounded number of times.
#include "craze/io/polygons/polygon.h"

#include <cmath>

namespace craze {

namespace {

/// Twice the signed area of a b c.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool inside(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// The corners in the plane normal to Newell's normal, scaled to about unit size; empty where the
/// polygon has no area.
std::vector<Vec2> flatten(std::span<const Vec3> corners) {
  double size = 0;
  for (const Vec3& p : corners) size = std::max(size, (p - corners[0]).lpNorm<Eigen::Infinity>());
  if (!(size > 0) || !std::isfinite(size)) return {};
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = (corners[i] - corners[0]) / size;
    const Vec3 b = (corners[(i + 1) % corners.size()] - corners[0]) / size;
    normal += a.cross(b);
  }
  if (!(normal.norm() > 0)) return {};
  normal.normalize();
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  std::vector<Vec2> flat;
  flat.reserve(corners.size());
  for (const Vec3& p : corners) {
    const Vec3 d = (p - corners[0]) / size;
    flat.emplace_back(d.dot(x), d.dot(y));
  }
  return flat;
}

/// The polygon's corners in a ring; corners are taken out one at a time.
class EarClipper {
 public:
  explicit EarClipper(const std::vector<Vec2>& p)
      : p_(p),
        left_(static_cast<std::int32_t>(p.size())),
        next_(p.size()),
        previous_(p.size()),
        known_(p.size(), false) {
    for (std::int32_t i = 0; i < left_; ++i) {
      next_[i] = (i + 1) % left_;
      previous_[i] = (i + left_ - 1) % left_;
      if (turn_at(i) < 0) reflex_.push_back(i);
    }
  }

  bool is_convex() const { return reflex_.empty(); }

  void clip(std::vector<CornerTriple>& triangles) {
    std::int32_t i = 0, misses = 0;
    while (left_ > 3) {
      if (misses < left_ && (known_[i] || !is_ear(i))) {
        known_[i] = true;
        i = next_[i];
        ++misses;
        continue;
      }
      // An ear, or no ear is left because the outline crosses itself: cut here all the same.
      triangles.push_back({previous_[i], i, next_[i]});
      i = take_out(i);
      misses = 0;
    }
    triangles.push_back({previous_[i], i, next_[i]});
  }

 private:
  double turn_at(std::int32_t i) const { return turn(p_[previous_[i]], p_[i], p_[next_[i]]); }

  bool is_ear(std::int32_t i) const {
    const std::int32_t a = previous_[i], c = next_[i];
    if (!(turn_at(i) > 0)) return false;
    for (const std::int32_t r : reflex_) {
      if (r == a || r == c || p_[r] == p_[a] || p_[r] == p_[c]) continue;
      if (inside(p_[r], p_[a], p_[i], p_[c])) return false;
    }
    return true;
  }

  /// Returns the corner to go on with: two steps on, which keeps the triangles from making a fan.
  std::int32_t take_out(std::int32_t i) {
    const std::int32_t a = previous_[i], c = next_[i];
    next_[a] = c;
    previous_[c] = a;
    --left_;
    known_[a] = known_[c] = false;
    std::erase_if(
        reflex_, [&](std::int32_t r) { return r == i || ((r == a || r == c) && turn_at(r) >= 0); });
    return next_[c];
  }

  const std::vector<Vec2>& p_;
  std::int32_t left_;
  std::vector<std::int32_t> next_, previous_;
  std::vector<std::int32_t> reflex_;
  std::vector<bool> known_;  ///< not an ear, and no neighbour has changed since
};

}  // namespace

bool triangulate_polygon(std::span<const Vec3> corners, std::vector<CornerTriple>& triangles) {
  const auto n = static_cast<std::int32_t>(corners.size());
  if (n > 3) {
    const std::vector<Vec2> flat = flatten(corners);
    if (!flat.empty()) {
      EarClipper clipper(flat);
      if (!clipper.is_convex()) {
        if (corners.size() > max_concave_corners) return false;
        clipper.clip(triangles);
        return true;
      }
    }
  }
  for (std::int32_t i = 1; i + 1 < n; ++i) triangles.push_back({0, i, i + 1});
  return true;
}

}  // namespace craze
