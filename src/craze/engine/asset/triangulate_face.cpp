#include "craze/engine/asset/triangulate_face.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace craze {

namespace {

constexpr double flip_margin =
    1e-10;  // of the angle sum's sine: cocircular points stay as they are

}  // namespace

void FaceTriangulator::run(const FaceDrawing& drawing) {
  points_ = drawing.points;
  metric_ = drawing.metric;
  tolerance_ = drawing.tolerance;
  hint_ = lost_ = 0;
  lines_.clear();
  same_as_.resize(points_.size());
  for (std::size_t p = 0; p < points_.size(); ++p) same_as_[p] = static_cast<std::int32_t>(p);
  from_.assign({0, 1, 2});
  opposite_.assign(3, -1);
  label_.assign(3, border_edge);
  start_.assign(points_.size(), -1);
  start_[0] = 0;
  start_[1] = 1;
  start_[2] = 2;

  add_border_points(drawing);
  const std::int32_t inner = 3 + drawing.on_edge[0] + drawing.on_edge[1] + drawing.on_edge[2];
  for (auto p = inner; p < static_cast<std::int32_t>(drawing.points.size()); ++p) {
    add_inner_point(p);
  }
  for (const FaceSegment& segment : drawing.segments) draw(segment);
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(from_.size()); ++h) {
    if (label_[h] >= 0 && opposite_[h] < h) lines_.push_back({from_[h], to(h), label_[h]});
  }
}

// ---- Triangles and their edges.

template <class Visit>
void FaceTriangulator::for_each_outgoing(std::int32_t v, Visit&& visit) const {
  const std::int32_t begin = start_[v];
  std::int32_t h = begin;
  do {
    if (!visit(h)) return;
    h = opposite_[prev(h)];
  } while (h >= 0 && h != begin);
  if (h == begin) return;
  for (h = opposite_[begin]; h >= 0; h = opposite_[h]) {
    h = next(h);
    if (!visit(h)) return;
  }
}

/// The halfedge from a to b, or −1; on the face's edge it may exist only as b to a.
std::int32_t FaceTriangulator::find(std::int32_t a, std::int32_t b) const {
  std::int32_t found = -1;
  for_each_outgoing(a, [&](std::int32_t h) {
    if (to(h) == b) found = h;
    if (apex(h) == b && opposite_[prev(h)] < 0) found = prev(h);
    return found < 0;
  });
  return found;
}

void FaceTriangulator::link(std::int32_t h, std::int32_t o) {
  opposite_[h] = o;
  if (o >= 0) opposite_[o] = h;
}

/// Puts point p on edge h, whose triangles it halves. Returns the second half, p → to(h).
std::int32_t FaceTriangulator::split_edge(std::int32_t h, std::int32_t p) {
  const std::int32_t o = opposite_[h], label = label_[h];
  const auto halve = [&](std::int32_t g) {
    const std::int32_t q = to(g), c = apex(g), edge = next(g);
    const auto half = static_cast<std::int32_t>(from_.size());
    from_.insert(from_.end(), {p, q, c});
    opposite_.insert(opposite_.end(), 3, -1);
    label_.insert(label_.end(), {label, label_[edge], free_edge});
    link(half + 1, opposite_[edge]);
    from_[edge] = p;
    label_[edge] = free_edge;
    link(edge, half + 2);
    start_[q] = half + 1;
    return half;
  };
  const std::int32_t second = halve(h);
  start_[p] = second;
  if (o >= 0) {
    const std::int32_t other = halve(o);
    link(h, other);
    link(o, second);
  }
  return second;
}

void FaceTriangulator::split_triangle(std::int32_t t, std::int32_t p) {
  const std::int32_t h = 3 * t, a = from_[h], b = from_[h + 1], c = from_[h + 2];
  const auto fresh = static_cast<std::int32_t>(from_.size());
  const std::int32_t bc = opposite_[h + 1], ca = opposite_[h + 2];
  from_.insert(from_.end(), {b, c, p, c, a, p});
  label_.insert(label_.end(),
                {label_[h + 1], free_edge, free_edge, label_[h + 2], free_edge, free_edge});
  opposite_.insert(opposite_.end(), 6, -1);
  from_[h + 2] = p;
  label_[h + 1] = label_[h + 2] = free_edge;
  link(fresh, bc);
  link(fresh + 3, ca);
  link(h + 1, fresh + 2);
  link(fresh + 1, fresh + 5);
  link(fresh + 4, h + 2);
  start_[a] = h;
  start_[b] = fresh;
  start_[c] = fresh + 3;
  start_[p] = h + 2;
}

void FaceTriangulator::flip(std::int32_t h) {
  const std::int32_t o = opposite_[h];
  const std::int32_t a = from_[h], b = from_[o], c = apex(h), d = apex(o);
  const std::int32_t ad = next(o), db = prev(o), bc = next(h), ca = prev(h);
  struct Outer {
    std::int32_t opposite, label;
  };
  const Outer out_ad{opposite_[ad], label_[ad]}, out_db{opposite_[db], label_[db]},
      out_bc{opposite_[bc], label_[bc]}, out_ca{opposite_[ca], label_[ca]};
  const std::int32_t s = h - h % 3, t = o - o % 3;  // become (a, d, c) and (d, b, c)
  const auto set = [&](std::int32_t g, std::int32_t v, const Outer& outer) {
    from_[g] = v;
    label_[g] = outer.label;
    link(g, outer.opposite);
    start_[v] = g;
  };
  set(s, a, out_ad);
  set(s + 1, d, {t + 2, free_edge});
  set(s + 2, c, out_ca);
  set(t, d, out_db);
  set(t + 1, b, out_bc);
  set(t + 2, c, {s + 1, free_edge});
}

/// Whether the two triangles at h make a strictly convex quadrilateral.
bool FaceTriangulator::is_convex(std::int32_t h) const {
  const std::int32_t o = opposite_[h], c = apex(h), d = apex(o);
  return side(from_[h], d, c) > 0 && side(d, from_[o], c) > 0;
}

/// Whether the angles opposite the edge sum to more than π in the face's own metric.
bool FaceTriangulator::wants_flip(std::int32_t h) const {
  if (label_[h] != free_edge) return false;
  const GridPoint &a = points_[from_[h]], &b = points_[to(h)];
  const auto dot = [&](const GridPoint& c) {
    const double ux = a.x - c.x, uy = a.y - c.y, vx = b.x - c.x, vy = b.y - c.y;
    return metric_[0] * ux * vx + metric_[1] * (ux * vy + uy * vx) + metric_[2] * uy * vy;
  };
  const GridPoint &c = points_[apex(h)], &d = points_[apex(opposite_[h])];
  const double dot_c = dot(c), dot_d = dot(d);
  const auto cross_c = static_cast<double>(orient(a, b, c)),
             cross_d = static_cast<double>(orient(b, a, d));
  return dot_c * cross_d + dot_d * cross_c <
             -flip_margin * (std::abs(dot_c) * cross_d + std::abs(dot_d) * cross_c) &&
         is_convex(h);
}

void FaceTriangulator::legalize() {
  // Delaunay flips end of themselves; rounding in a face without area must not keep them going.
  std::size_t budget = 64 * from_.size() + 1024;
  while (!suspects_.empty() && budget-- > 0) {
    const std::int32_t h = suspects_.back();
    suspects_.pop_back();
    if (!wants_flip(h)) continue;
    const std::int32_t o = opposite_[h], s = h - h % 3, t = o - o % 3;
    flip(h);
    suspects_.insert(suspects_.end(), {s, s + 2, t, t + 1});
  }
  suspects_.clear();
}

void FaceTriangulator::legalize_around(std::int32_t v) {
  for_each_outgoing(v, [&](std::int32_t h) {
    suspects_.push_back(next(h));
    return true;
  });
  legalize();
}

// ---- Points.

void FaceTriangulator::add_border_points(const FaceDrawing& drawing) {
  std::int32_t p = 3;
  for (std::int32_t i = 0; i < 3; ++i) {
    const std::int32_t end = (i + 1) % 3;
    std::int32_t last = i;
    for (std::int32_t k = 0; k < drawing.on_edge[i]; ++k, ++p) {
      split_edge(find(last, end), p);
      legalize_around(p);
      last = p;
    }
  }
}

bool FaceTriangulator::is_near(const GridPoint& a, const GridPoint& b) const {
  return std::abs(std::int64_t{a.x} - b.x) <= tolerance_ &&
         std::abs(std::int64_t{a.y} - b.y) <= tolerance_;
}

/// Whether c, off the ends, lies on the segment pq or so near that it goes through it.
bool FaceTriangulator::passes_near(std::int32_t p, std::int32_t q, std::int32_t c) const {
  const GridPoint &a = points_[p], &b = points_[q], &m = points_[c];
  const double x = b.x - a.x, y = b.y - a.y, squared = x * x + y * y;
  const double along = x * (m.x - a.x) + y * (m.y - a.y);
  if (along <= 0 || along >= squared) return false;
  const auto area = static_cast<double>(side(p, q, c));
  const auto limit = static_cast<double>(tolerance_);
  return area * area <= limit * limit * squared;
}

/// The triangle that holds p, by a walk from the last one.
std::int32_t FaceTriangulator::locate(const GridPoint& p) const {
  std::int32_t t = hint_;
  const std::int32_t triangles = triangle_count();
  for (std::int32_t step = 0; step < triangles + 3; ++step) {
    std::int32_t out = -1;
    for (std::int32_t k = 0; k < 3 && out < 0; ++k) {
      const std::int32_t h = 3 * t + (k + step) % 3;
      if (orient(points_[from_[h]], points_[to(h)], p) < 0) out = opposite_[h];
    }
    if (out < 0) return t;
    t = out / 3;
  }
  for (t = 0; t < triangles; ++t) {  // the walk went in a circle
    bool inside = true;
    for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
      inside = inside && orient(points_[from_[h]], points_[to(h)], p) >= 0;
    }
    if (inside) return t;
  }
  return 0;
}

void FaceTriangulator::add_inner_point(std::int32_t p) {
  const std::int32_t t = locate(points_[p]);
  hint_ = t;
  for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
    if (!is_near(points_[from_[h]], points_[p])) continue;
    same_as_[p] = from_[h];
    return;
  }
  std::int32_t on = -1;
  for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
    if (side(from_[h], to(h), p) == 0) on = h;
  }
  if (on >= 0) {
    split_edge(on, p);
  } else {
    split_triangle(t, p);
  }
  legalize_around(p);
}

// ---- Segments.

void FaceTriangulator::draw(const FaceSegment& segment) {
  pending_.assign(1, {same_as_[segment.a], same_as_[segment.b]});
  std::size_t budget = 4 * from_.size() + 64;
  while (!pending_.empty()) {
    const auto [p, q] = pending_.back();
    pending_.pop_back();
    if (p == q) continue;
    if (budget-- == 0) {
      ++lost_;
      return;
    }
    const Obstacle met = first_obstacle(p, q);
    switch (met.kind) {
      case Meets::edge_exists:
        mark(met.at, segment.label);
        break;
      case Meets::nothing:
        force_edge(p, q);
        if (const std::int32_t h = find(p, q); h >= 0) {
          mark(h, segment.label);
        } else {
          ++lost_;
        }
        legalize();
        break;
      case Meets::point:
        pending_.emplace_back(met.at, q);
        pending_.emplace_back(p, met.at);
        break;
      case Meets::line:
        cross_line(met.at, p, q);
        break;
    }
  }
}

/// What the segment from p to q meets first. Nothing: crossed_ then holds the free edges that it
/// crosses, in order.
FaceTriangulator::Obstacle FaceTriangulator::first_obstacle(std::int32_t p, std::int32_t q) {
  Obstacle found{Meets::nothing, -1};
  std::int32_t h = -1;  // crossed by the segment, from its right to its left
  for_each_outgoing(p, [&](std::int32_t out) {
    const std::int32_t a = to(out), b = apex(out);
    for (const std::int32_t edge : {out, prev(out)}) {
      if ((edge == out ? a : b) == q) found = {Meets::edge_exists, edge};
    }
    if (found.kind == Meets::edge_exists) return false;
    for (const std::int32_t end : {a, b}) {
      if (found.kind == Meets::nothing && passes_near(p, q, end)) found = {Meets::point, end};
    }
    if (side(p, q, a) < 0 && side(p, q, b) > 0) h = next(out);
    return true;
  });
  if (found.kind != Meets::nothing) return found;
  crossed_.clear();
  while (h >= 0) {
    if (label_[h] != free_edge) return {Meets::line, h};
    crossed_.emplace_back(from_[h], to(h));
    const std::int32_t o = opposite_[h], c = apex(o);
    if (c == q) break;
    if (passes_near(p, q, c)) return {Meets::point, c};
    h = side(p, q, c) < 0 ? prev(o) : next(o);
  }
  return found;
}

/// Flips the edges in crossed_ until none is in the way.
void FaceTriangulator::force_edge(std::int32_t p, std::int32_t q) {
  std::size_t budget = 16 * crossed_.size() * crossed_.size() + 64;
  for (std::size_t i = 0; i < crossed_.size() && budget-- > 0; ++i) {
    const auto [u, v] = crossed_[i];
    const std::int32_t h = find(u, v);
    assert(h >= 0 && opposite_[h] >= 0);
    if (!is_convex(h)) {
      crossed_.emplace_back(u, v);
      continue;
    }
    const std::int32_t c = apex(h), d = apex(opposite_[h]);
    const std::int32_t s = h - h % 3, o = opposite_[h], t = o - o % 3;
    flip(h);
    suspects_.insert(suspects_.end(), {s, s + 1, s + 2, t, t + 1});
    const bool has_end = c == p || c == q || d == p || d == q;
    if (!has_end && (side(p, q, c) > 0) != (side(p, q, d) > 0)) crossed_.emplace_back(c, d);
  }
}

void FaceTriangulator::mark(std::int32_t h, std::int32_t label) {
  if (label_[h] >= 0) label = std::min(label, label_[h]);
  label_[h] = label;
  if (opposite_[h] >= 0) label_[opposite_[h]] = label;
}

/// Leads the line h through v, the apex of one of its triangles: its two other edges take over.
bool FaceTriangulator::lead_through(std::int32_t v, std::int32_t h) {
  const std::int32_t g = apex(h) == v ? h : opposite_[h] >= 0 ? opposite_[h] : h;
  if (apex(g) != v || label_[h] < 0) return false;
  mark(next(g), label_[h]);
  mark(prev(g), label_[h]);
  label_[g] = label_[opposite_[g]] = free_edge;
  suspects_.push_back(g);
  legalize();
  return true;
}

/// Makes the segment from p to q and the line h, which crosses it, share a point.
void FaceTriangulator::cross_line(std::int32_t h, std::int32_t p, std::int32_t q) {
  const std::int32_t a = from_[h], b = to(h);
  const auto right = static_cast<double>(-side(p, q, a)), left = static_cast<double>(side(p, q, b));
  const double t = right / (right + left);
  const GridPoint &pa = points_[a], &pb = points_[b];
  const GridPoint x{static_cast<std::int32_t>(std::lround(pa.x + t * (pb.x - pa.x))),
                    static_cast<std::int32_t>(std::lround(pa.y + t * (pb.y - pa.y)))};
  const auto go_through = [&](std::int32_t c) {
    pending_.emplace_back(c, q);
    pending_.emplace_back(p, c);
  };
  if (is_near(x, pa)) return go_through(a);
  if (is_near(x, pb)) return go_through(b);
  for (const std::int32_t end : {p, q}) {
    if (is_near(x, points_[end]) && lead_through(end, h)) {
      pending_.emplace_back(p, q);
      return;
    }
  }
  const std::int32_t o = opposite_[h];
  const std::int32_t c = apex(h), d = o >= 0 ? apex(o) : -1;
  const bool fits = o >= 0 && orient(pa, x, points_[c]) > 0 && orient(x, pb, points_[c]) > 0 &&
                    orient(pb, x, points_[d]) > 0 && orient(x, pa, points_[d]) > 0;
  if (!fits) return go_through(t < 0.5 ? a : b);
  const auto crossing = static_cast<std::int32_t>(points_.size());
  points_.push_back(x);
  start_.push_back(-1);
  split_edge(h, crossing);
  legalize_around(crossing);
  go_through(crossing);
}

}  // namespace craze
