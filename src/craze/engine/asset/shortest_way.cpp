#include "craze/engine/asset/shortest_way.h"

#include <algorithm>
#include <cmath>

#include "craze/base/segment_distance.h"

namespace craze {

namespace {

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The third corner of a triangle laid out flat, right of the way from a to b.
Vec2 third_corner(const Vec2& a, const Vec2& b, double to_a, double to_b) {
  const Vec2 d = b - a;
  const double length = d.norm();
  if (!(length > 0)) return a + Vec2(to_a, 0);
  const double along = (to_a * to_a - to_b * to_b + length * length) / (2 * length);
  const double beside = std::sqrt(std::max(0.0, to_a * to_a - along * along));
  return a + (along * d + beside * Vec2(d.y(), -d.x())) / length;
}

/// An edge of the strip laid out flat, as a door to go through.
struct Door {
  Vec2 left, right;
};

/// The shortest way through doors, door after door: for each the share from left to right at which
/// it goes through. The funnel of [Lee, Preparata: Euclidean shortest paths in the presence of
/// rectilinear barriers, 1984], begun anew at each bend.
std::vector<double> tight_way(const Vec2& start, const std::vector<Door>& doors,
                              const Vec2& target) {
  const std::size_t n = doors.size();  // as a door, the target
  const auto left = [&](std::size_t k) -> Vec2 { return k < n ? doors[k].left : target; };
  const auto right = [&](std::size_t k) -> Vec2 { return k < n ? doors[k].right : target; };
  std::vector<double> shares(n, 0);
  Vec2 apex = start;
  std::size_t first = 0;  // the first door after the apex
  const auto go_straight = [&](const Vec2& to, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Vec2 door = doors[k].right - doors[k].left, way = to - apex;
      const double s = cross(apex - doors[k].left, way) / cross(door, way);
      const bool left_is_nearer = (doors[k].left - apex).norm() < (doors[k].right - apex).norm();
      shares[k] = std::isfinite(s) ? std::clamp(s, 0.0, 1.0) : left_is_nearer ? 0 : 1;
    }
    apex = to;
    first = last + 1;
  };
  std::size_t at_left = 0, at_right = 0;  // the doors that the funnel's sides touch
  for (std::size_t k = 0; k <= n; ++k) {
    const Vec2 on_left = left(at_left) - apex, on_right = right(at_right) - apex;
    const Vec2 next_left = left(k) - apex, next_right = right(k) - apex;
    const bool narrows_right = cross(on_right, next_right) >= 0;
    const bool narrows_left = cross(on_left, next_left) <= 0;
    if (narrows_right && cross(on_left, next_right) > 0) {  // all the doors' right is beyond left
      if (at_left < n) shares[at_left] = 0;
      go_straight(left(at_left), at_left);
    } else if (narrows_left && cross(on_right, next_left) < 0) {
      if (at_right < n) shares[at_right] = 1;
      go_straight(right(at_right), at_right);
    } else {
      if (narrows_right) at_right = k;
      if (narrows_left) at_left = k;
      continue;
    }
    at_left = at_right = first;
    k = first - 1;
  }
  if (first <= n) go_straight(target, n);
  return shares;
}

}  // namespace

SurfaceWay ShortestWay::find(std::int32_t from, std::int32_t to, double most) {
  start_ = place_of(from);
  target_ = place_of(to);
  most_ = most;
  reached_.clear();
  queue_ = {};
  sites_.for_each_face(from, [&](std::int32_t f) {
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      if (!is_on(from, h)) reach(h, -1, start_, 0);
    }
    return true;
  });
  SurfaceWay way;
  while (!queue_.empty() && way.last_face < 0) {
    const std::int32_t edge = std::get<1>(queue_.top());
    queue_.pop();
    Reached& here = reached_.at(edge);
    if (here.done) continue;
    here.done = true;
    const std::int32_t ahead = face_beyond(here.halfedge);
    if (sites_.touches(to, ahead)) {
      way.last_face = ahead;
      for (std::int32_t e = edge; e >= 0; e = reached_.at(e).before) {
        const std::int32_t h = reached_.at(e).halfedge;
        way.crossings.push_back({h / 3, h, 0});
      }
      std::reverse(way.crossings.begin(), way.crossings.end());
      pull_tight(from, to, way);
      break;
    }
    const Vec3 at = here.at;  // reach() may move what is reached
    const double cost = here.cost;
    for (std::int32_t h = 3 * ahead; h < 3 * ahead + 3; ++h) {
      if (topology_.edge(h) != edge) reach(h, edge, at, cost);
    }
  }
  return way;
}

/// The face on the other side of a halfedge that has one.
std::int32_t ShortestWay::face_beyond(std::int32_t h) const {
  const HalfedgeRange sides = topology_.sides(topology_.edge(h));
  return (*sides.begin() == h ? *(sides.begin() + 1) : *sides.begin()) / 3;
}

/// Whether a site lies on a halfedge or at one of its ends.
bool ShortestWay::is_on(std::int32_t site, std::int32_t h) const {
  const Site& s = sites_[site];
  if (s.kind == SiteKind::place) return topology_.from(h) == s.where || topology_.to(h) == s.where;
  return s.kind == SiteKind::edge && topology_.edge(h) == s.where;
}

void ShortestWay::reach(std::int32_t h, std::int32_t before, const Vec3& here, double cost) {
  const std::int32_t edge = topology_.edge(h);
  if (edge < 0 || topology_.sides(edge).size() != 2 || face_beyond(h) == h / 3) return;
  const auto known = reached_.find(edge);
  const Vec3 at = known != reached_.end() ? known->second.at : nearest_to_chord(h);
  const double further = cost + (at - here).norm(), whole = further + (target_ - at).norm();
  if (!(whole <= most_)) return;
  if (known != reached_.end() && (known->second.done || known->second.cost <= further)) return;
  reached_[edge] = {further, h, before, at};
  queue_.emplace(whole, edge);
}

Vec3 ShortestWay::nearest_to_chord(std::int32_t h) const {
  const Vec3 &a = asset_.positions[topology_.from(h)], &b = asset_.positions[topology_.to(h)];
  const Vec3 edge = b - a, chord = target_ - start_, gap = a - start_;
  const double ee = edge.squaredNorm(), cc = chord.squaredNorm(), ec = edge.dot(chord);
  // Where the chord's line comes nearest to the edge's, kept on the chord; then the edge's nearest.
  const double determinant = ee * cc - ec * ec;
  double t = determinant > 0 ? (ee * chord.dot(gap) - ec * edge.dot(gap)) / determinant : 0.5;
  t = std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0.5;
  return a + nearest_on_segment(start_ + t * chord, a, b) * edge;
}

/// Lays the strip out flat and sets the shares of its crossings.
void ShortestWay::pull_tight(std::int32_t from, std::int32_t to, SurfaceWay& way) const {
  const auto distance = [&](std::int32_t p, std::int32_t q) {
    return (asset_.positions[p] - asset_.positions[q]).norm();
  };
  const auto third = [&](std::int32_t face, std::int32_t p, std::int32_t q) {
    std::int32_t h = 3 * face;
    while (topology_.from(h) == p || topology_.from(h) == q) ++h;
    return topology_.from(h);
  };
  // Of the door at hand: places of its ends, and where they are laid out.
  const std::int32_t first = way.crossings.front().halfedge;
  std::int32_t right = topology_.from(first), left = topology_.to(first);
  Door door{Vec2(distance(left, right), 0), Vec2::Zero()};
  // A site's place in a face that is laid out.
  const auto place_in = [&](std::int32_t site, std::int32_t face, std::int32_t other,
                            const Vec2& other_at) {
    const Vec3 weights = weights_of(sites_.in_face(site, face));
    Vec2 sum = Vec2::Zero();
    for (int i = 0; i < 3; ++i) {
      const std::int32_t corner = topology_.from(3 * face + i);
      sum += weights[i] * (corner == other ? other_at : corner == left ? door.left : door.right);
    }
    return sum;
  };
  const std::int32_t behind = third(first / 3, left, right);
  const Vec2 start = place_in(
      from, first / 3, behind,
      third_corner(door.left, door.right, distance(left, behind), distance(right, behind)));
  std::vector<Door> doors;
  std::vector<std::int32_t> lefts;  // of the doors: places
  Vec2 target = Vec2::Zero();
  for (std::size_t k = 0; k < way.crossings.size(); ++k) {
    doors.push_back(door);
    lefts.push_back(left);
    const bool is_last = k + 1 == way.crossings.size();
    const std::int32_t face = is_last ? way.last_face : way.crossings[k + 1].face;
    const std::int32_t other = third(face, left, right);
    const Vec2 at =
        third_corner(door.right, door.left, distance(right, other), distance(left, other));
    if (is_last) {
      target = place_in(to, face, other, at);
    } else {
      const std::int32_t h = way.crossings[k + 1].halfedge;
      const bool keeps_left = topology_.from(h) == left || topology_.to(h) == left;
      (keeps_left ? right : left) = other;
      (keeps_left ? door.right : door.left) = at;
    }
  }
  const std::vector<double> shares = tight_way(start, doors, target);
  Vec3 last = start_;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    Crossing& c = way.crossings[k];
    c.share = topology_.from(c.halfedge) == lefts[k] ? shares[k] : 1 - shares[k];
    const Vec3 &a = asset_.positions[topology_.from(c.halfedge)],
               &b = asset_.positions[topology_.to(c.halfedge)];
    const Vec3 at = (1 - c.share) * a + c.share * b;
    way.length += (at - last).norm();
    last = at;
  }
  way.length += (target_ - last).norm();
}

}  // namespace craze
