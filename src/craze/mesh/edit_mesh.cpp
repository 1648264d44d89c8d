#include "craze/mesh/edit_mesh.h"

#include <algorithm>

namespace craze {

EditMesh::EditMesh(const TriangleMesh& mesh, std::vector<char> marks)
    : positions_(mesh.positions()),
      triangles_(mesh.triangles()),
      marks_(std::move(marks)),
      period_(mesh.period()) {
  opposite_.reserve(marks_.size());
  first_.reserve(positions_.size());
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) opposite_.push_back(mesh.opposite(h));
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) first_.push_back(mesh.first_halfedge(v));
  on_line_.resize(positions_.size(), 0);
  for (std::int32_t h = 0; h < halfedge_slots(); ++h) {
    if (marks_[h] != 0) on_line_[from(h)] = on_line_[to(h)] = 1;
  }
}

bool EditMesh::are_neighbours(std::int32_t v, std::int32_t w) const {
  bool found = false;
  for_each_outgoing(v, [&](std::int32_t h) { found = found || to(h) == w || apex(h) == w; });
  return found;
}

int EditMesh::count_marked_around(std::int32_t v) const {
  int count = 0;
  for_each_outgoing(v, [&](std::int32_t h) {
    count += marks_[h] != 0;
    count += opposite_[prev(h)] < 0 && marks_[prev(h)] != 0;
  });
  return count;
}

void EditMesh::link(std::int32_t g, std::int32_t h) {
  if (g >= 0) opposite_[g] = h;
  if (h >= 0) opposite_[h] = g;
}

// h leaves v: turns clockwise from it to where the fan of v starts.
void EditMesh::refresh_first(std::int32_t v, std::int32_t h) {
  const std::int32_t begin = h;
  while (opposite_[h] >= 0) {
    h = next(opposite_[h]);
    if (h == begin) break;
  }
  first_[v] = h;
}

std::int32_t EditMesh::split(std::int32_t h, const Vec3& p) {
  const std::int32_t o = opposite_[h], x = vertex_count();
  positions_.push_back(p);
  first_.push_back(-1);
  on_line_.push_back(marks_[h] != 0 ? 1 : 0);
  // g = (q0 → q) becomes q0 → x; the new face is (x, q, apex). Returns x → q.
  const auto halve = [&](std::int32_t g) {
    const std::int32_t f = g / 3, side = next(g), q = to(g), top = apex(g);
    const std::int32_t half = 3 * face_slots();
    triangles_.push_back({x, q, top});
    triangles_[f][side % 3] = x;
    const char mark_g = marks_[g], mark_side = marks_[side];
    marks_.insert(marks_.end(), {mark_g, mark_side, 0});
    marks_[side] = 0;
    const std::int32_t outer = opposite_[side];
    opposite_.insert(opposite_.end(), {-1, -1, -1});
    link(half + 1, outer);
    link(half + 2, side);
    if (first_[q] == side) first_[q] = half + 1;
    return half;
  };
  const std::int32_t xb = halve(h);
  first_[x] = xb;
  if (o < 0) return x;
  const std::int32_t xa = halve(o);
  link(h, xa);
  link(o, xb);
  return x;
}

bool EditMesh::marks_allow_collapse(std::int32_t h) const {
  const int marked = count_marked(from(h));
  return marked == 0 || (marked == 2 && marks_[h] != 0);
}

bool EditMesh::can_collapse(std::int32_t h) const {
  const std::int32_t a = from(h), b = to(h), o = opposite_[h];
  if (!marks_allow_collapse(h)) return false;
  // A border vertex goes only along the border.
  if (is_border_vertex(a) && o >= 0) return false;
  // Around a removed face: not both other sides open, and no top that would lose its fan.
  for (const std::int32_t g : {h, o}) {
    if (g < 0) continue;
    const std::int32_t n = opposite_[next(g)], p = opposite_[prev(g)], top = apex(g);
    if (n < 0 && p < 0) return false;
    if (marks_[next(g)] != 0 && marks_[prev(g)] != 0) return false;  // two lines would merge
    if (is_border_vertex(top)) continue;
    int valence = 0;
    for_each_outgoing(top, [&](std::int32_t) { ++valence; });
    if (valence <= 3) return false;
  }
  // Link condition: a and b share no neighbours but the tops of the removed faces.
  int shared = 0;
  const auto count_shared = [&](std::int32_t w) {
    if (w != b && are_neighbours(b, w)) ++shared;
  };
  for_each_outgoing(a, [&](std::int32_t g) {
    count_shared(to(g));
    if (opposite_[prev(g)] < 0) count_shared(apex(g));
  });
  return shared == (o < 0 ? 1 : 2);
}

void EditMesh::remove_face_of(std::int32_t h) {
  triangles_[h / 3] = {-1, -1, -1};
  for (std::int32_t g = 3 * (h / 3); g < 3 * (h / 3) + 3; ++g) {
    opposite_[g] = -1;
    marks_[g] = 0;
  }
}

void EditMesh::collapse(std::int32_t h) {
  const std::int32_t a = from(h), b = to(h), o = opposite_[h];
  const std::int32_t top = apex(h), other_top = o < 0 ? -1 : apex(o);
  std::vector<std::int32_t> fan;
  for_each_outgoing(a, [&](std::int32_t g) { fan.push_back(g); });
  for (std::int32_t g : fan) triangles_[g / 3][g % 3] = b;
  // The two outer sides of each removed face become the sides of one edge.
  std::int32_t leaves_b = -1, leaves_top = -1, leaves_other = -1;
  const auto close = [&](std::int32_t g, std::int32_t& leaves) {
    const std::int32_t n = opposite_[next(g)], p = opposite_[prev(g)];
    const char mark = static_cast<char>(std::max(marks_[next(g)], marks_[prev(g)]));
    for (const std::int32_t s : {n, p}) {
      if (s < 0) continue;
      marks_[s] = mark;
      // Either side leads to a halfedge that leaves b and one that leaves the top.
      const bool from_b = triangles_[s / 3][s % 3] == b;
      leaves_b = from_b ? s : next(s);
      leaves = from_b ? next(s) : s;
    }
    if (n >= 0) opposite_[n] = p;
    if (p >= 0) opposite_[p] = n;
    remove_face_of(g);
  };
  close(h, leaves_top);
  if (o >= 0) close(o, leaves_other);
  first_[a] = -1;
  refresh_first(b, leaves_b);
  refresh_first(top, leaves_top);
  if (other_top >= 0) refresh_first(other_top, leaves_other);
}

bool EditMesh::can_flip(std::int32_t h) const {
  if (opposite_[h] < 0 || marks_[h] != 0) return false;
  const std::int32_t c = apex(h), d = apex(opposite_[h]);
  return c != d && !are_neighbours(c, d);
}

void EditMesh::flip(std::int32_t h) {
  // h = a → b with top c, o = b → a with top d.
  const std::int32_t o = opposite_[h], a = from(h), b = to(h), c = apex(h), d = apex(o);
  const std::int32_t f = 3 * (h / 3), g = 3 * (o / 3);
  const std::int32_t bc = opposite_[next(h)], ca = opposite_[prev(h)];
  const std::int32_t ad = opposite_[next(o)], db = opposite_[prev(o)];
  const char mark_bc = marks_[next(h)], mark_ca = marks_[prev(h)];
  const char mark_ad = marks_[next(o)], mark_db = marks_[prev(o)];
  // Faces (c, a, d) and (d, b, c); their sides 2 are d → c and c → d.
  triangles_[f / 3] = {c, a, d};
  triangles_[g / 3] = {d, b, c};
  const auto set = [&](std::int32_t side, std::int32_t outer, char mark) {
    opposite_[side] = outer;
    if (outer >= 0) opposite_[outer] = side;
    marks_[side] = mark;
  };
  set(f, ca, mark_ca);
  set(f + 1, ad, mark_ad);
  set(g, db, mark_db);
  set(g + 1, bc, mark_bc);
  link(f + 2, g + 2);
  marks_[f + 2] = marks_[g + 2] = 0;
  refresh_first(a, f + 1);
  refresh_first(b, g + 1);
  refresh_first(c, f);
  refresh_first(d, g);
}

std::vector<Triangle> EditMesh::compact(std::vector<std::int32_t>& kept) const {
  std::vector<std::int32_t> index(positions_.size(), -1);
  kept.clear();
  for (std::int32_t v = 0; v < vertex_count(); ++v) {
    if (!is_vertex(v)) continue;
    index[v] = static_cast<std::int32_t>(kept.size());
    kept.push_back(v);
  }
  std::vector<Triangle> triangles;
  for (std::int32_t f = 0; f < face_slots(); ++f) {
    if (!is_face(f)) continue;
    const Triangle& t = triangles_[f];
    triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  }
  return triangles;
}

}  // namespace craze
