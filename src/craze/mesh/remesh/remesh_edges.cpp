#include "craze/mesh/remesh/remesh_edges.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <queue>
#include <tuple>

#include "craze/mesh/remesh/feature_lines.h"

namespace craze {

namespace {

// Of the length wanted: how straight a seam is to be thinned.
constexpr double seam_tolerance = 1e-6;

// Halfedges are asked for so many before they are looked at: faces, then their corners.
constexpr std::int32_t faces_ahead = 24, corners_ahead = 12;

/// The next halfedge from h on that is flagged, or the number of all. Asks early for what those
/// after it need.
std::int32_t next_flagged(const RemeshSurface& s, const std::vector<char>& flags, std::int32_t h) {
  const auto count = static_cast<std::int32_t>(flags.size());
  if (h >= count) return count;
  const void* found = std::memchr(&flags[h], 1, count - h);
  if (found == nullptr) return count;
  h = static_cast<std::int32_t>(static_cast<const char*>(found) - flags.data());
  const std::int32_t faces = h + faces_ahead, corners = h + corners_ahead;
  if (faces < count && flags[faces] != 0) s.mesh.prefetch_face_beyond(faces);
  if (corners < count && flags[corners] != 0) s.mesh.prefetch_corners(corners);
  return h;
}

struct LongEdge {
  double ratio;  // of its length to the one wanted
  std::int32_t h, from, to;
  bool operator<(const LongEdge& o) const { return std::tie(ratio, h) < std::tie(o.ratio, o.h); }
};

LongEdge measure(const RemeshSurface& s, std::int32_t h) {
  const std::int32_t a = s.mesh.from(h), b = s.mesh.to(h);
  return {s.edge_length(h) / s.wanted_length(a, b), h, a, b};
}

// Above too_short by more than rounding.
constexpr double surely_not_short = too_short * (1 + 1e-9);

// How far the vertex that goes lies from the line between its two neighbours on a marked line.
double distance_to_new_line(const RemeshSurface& s, std::int32_t h) {
  const std::int32_t a = s.mesh.from(h), b = s.mesh.to(h);
  std::int32_t other = -1;
  s.mesh.for_each_outgoing(a, [&](std::int32_t g) {
    if (s.mesh.mark(g) != no_feature && s.mesh.to(g) != b) other = s.mesh.to(g);
    const std::int32_t p = EditMesh::prev(g);
    if (s.mesh.opposite(p) < 0 && s.mesh.mark(p) != no_feature) other = s.mesh.from(p);
  });
  const Vec3 &p = s.mesh.position(a), &q = s.mesh.position(b), &r = s.mesh.position(other);
  const Vec3 w = nearest_weights(p, q, r, r);
  return (w[0] * q + (1 - w[0]) * r - p).norm();
}

bool may_collapse(const RemeshSurface& s, std::int32_t h) {
  if (!s.mesh.marks_allow_collapse(h)) return false;
  const std::int32_t a = s.mesh.from(h), b = s.mesh.to(h);
  if (s.mesh.mark(h) != no_feature) {
    const double off = distance_to_new_line(s, h);
    if (s.mesh.mark(h) == seam && off > seam_tolerance * s.wanted[a]) return false;
    if (std::max(s.line_error[a], s.line_error[b]) + off > s.max_distance / 4) return false;
  }
  // The faces that stay must not fold, stretch or leave the vertex far outside.
  bool good = true;
  double nearest = s.mesh.count_marked(a) > 0 ? 0 : 2 * s.max_distance;
  s.mesh.for_each_outgoing(a, [&](std::int32_t g) {
    const std::int32_t c = s.mesh.to(g), d = s.mesh.apex(g);
    if (!good || c == b || d == b) return;
    const Vec3& pa = s.mesh.position(a);
    const Vec3 pb = s.mesh.position_near(b, pa), pc = s.mesh.position_near(c, pa),
               pd = s.mesh.position_near(d, pa);
    const Vec3 before = s.face_cross(g / 3), after = cross_of(pb, pc, pd);
    if (!(after.dot(before) > 0.7 * after.norm() * before.norm()) ||
        (pc - pb).norm() > too_long * s.wanted_length(b, c) ||
        (pd - pb).norm() > too_long * s.wanted_length(b, d) ||
        after.norm() < 0.1 * (pc - pd).squaredNorm()) {
      good = false;
      return;
    }
    const Vec3 w = nearest_weights(pa, pb, pc, pd);
    nearest = std::min(nearest, (w[0] * pb + w[1] * pc + w[2] * pd - pa).norm());
  });
  return good && nearest <= s.max_distance / 2 && s.mesh.can_collapse(h);
}

void collapse(RemeshSurface& s, std::int32_t h) {
  const std::int32_t a = s.mesh.from(h), b = s.mesh.to(h);
  if (s.mesh.mark(h) != no_feature) {
    s.line_error[b] = std::max(s.line_error[a], s.line_error[b]) + distance_to_new_line(s, h);
  }
  s.mesh.collapse(h);
  s.look_around_again(b);
}

bool wants_flip(const RemeshSurface& s, std::int32_t h) {
  const std::int32_t o = s.mesh.opposite(h);
  if (o < 0 || s.mesh.mark(h) != no_feature) return false;
  const Vec3& a = s.mesh.position(s.mesh.from(h));
  const Vec3 b = s.mesh.position_near(s.mesh.to(h), a);
  const Vec3 c = s.mesh.position_near(s.mesh.apex(h), a);
  const Vec3 d = s.mesh.position_near(s.mesh.apex(o), a);
  const Vec3 above = (a - c).cross(b - c), below = (b - d).cross(a - d);
  const double area_c = above.norm(), area_d = below.norm();
  // cot γ + cot δ < 0: the two angles opposite the edge sum to more than a straight one.
  if ((a - c).dot(b - c) * area_d + (a - d).dot(b - d) * area_c >= -1e-9 * area_c * area_d) {
    return false;
  }
  const Vec3 left = cross_of(c, a, d), right = cross_of(d, b, c), side = above + below;
  const double least = 0.5 * side.norm();
  if (!(left.dot(side) > least * left.norm()) || !(right.dot(side) > least * right.norm())) {
    return false;
  }
  // The gap between the two diagonals is what the flip moves the surface by.
  const Vec3 axis = (b - a).cross(d - c);
  return std::abs((c - a).dot(axis)) <= 0.5 * s.max_distance * axis.norm();
}

}  // namespace

void split_long_edges(RemeshSurface& s) {
  for (;;) {
    std::vector<LongEdge> edges;
    double longest = 0;
    // What is measured here stays so until a face beside it changes.
    for (std::int32_t h = 0; (h = next_flagged(s, s.may_be_long, h)) < s.mesh.halfedge_slots();
         ++h) {
      s.step();
      const bool is_edge = s.mesh.is_edge(h);
      const LongEdge e = is_edge ? measure(s, h) : LongEdge{0, h, -1, -1};
      longest = std::max(longest, e.ratio);
      if (e.ratio > too_long) {
        edges.push_back(e);
        continue;
      }
      s.may_be_long[h] = 0;
      if (!is_edge || e.ratio > surely_not_short) s.may_be_short[h] = 0;
    }
    if (edges.empty()) return;
    const double limit = std::max(too_long, longest / 1.5);
    std::priority_queue<LongEdge> queue;
    const auto add = [&](const LongEdge& e) {
      if (e.ratio > limit) queue.push(e);
    };
    std::for_each(edges.begin(), edges.end(), add);
    while (!queue.empty()) {
      s.step();
      const LongEdge e = queue.top();
      queue.pop();
      if (s.mesh.from(e.h) != e.from || s.mesh.to(e.h) != e.to) continue;  // split or moved since
      const double t = 0.5 + 0.16 * (s.place.uniform() - 0.5);
      const Vec3& from = s.mesh.position(e.from);
      const std::int32_t x = s.split(e.h, (1 - t) * from + t * s.mesh.position_near(e.to, from));
      s.mesh.for_each_outgoing(x, [&](std::int32_t h) {
        for (std::int32_t g = 3 * (h / 3); g < 3 * (h / 3) + 3; ++g) add(measure(s, g));
      });
    }
    flip_edges(s);
  }
}

void collapse_short_edges(RemeshSurface& s) {
  for (std::int32_t h = 0; (h = next_flagged(s, s.may_be_short, h)) < s.mesh.halfedge_slots();
       ++h) {
    s.step();
    if (!s.mesh.is_edge(h)) continue;
    if (s.edge_length(h) >= too_short * s.wanted_length(s.mesh.from(h), s.mesh.to(h))) continue;
    const std::int32_t o = s.mesh.opposite(h);
    if (may_collapse(s, h)) {
      collapse(s, h);
    } else if (o >= 0 && may_collapse(s, o)) {
      collapse(s, o);
    }
  }
}

void flip_edges(RemeshSurface& s) {
  for (int sweep = 0, flips = 1; sweep < 12 && flips > 0; ++sweep) {
    flips = 0;
    for (std::int32_t h = 0; (h = next_flagged(s, s.may_flip, h)) < s.mesh.halfedge_slots(); ++h) {
      s.step();
      // Of an edge's two sides one stands for it until the faces beside it change.
      if (!s.mesh.is_edge(h) || !wants_flip(s, h)) {
        s.may_flip[h] = 0;
        continue;
      }
      if (!s.mesh.can_flip(h)) continue;
      const std::int32_t faces[] = {h / 3, s.mesh.opposite(h) / 3};
      s.mesh.flip(h);
      ++flips;
      for (const std::int32_t f : faces) s.look_at_again(f);
    }
  }
}

}  // namespace craze
