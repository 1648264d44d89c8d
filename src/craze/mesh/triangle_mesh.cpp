#include "craze/mesh/triangle_mesh.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "craze/error.h"
#include "craze/mesh/sorted_halfedges.h"

namespace craze {

namespace {

[[noreturn]] void fail(std::int32_t face, const std::string& why) {
  throw Error(ErrorKind::request, "mesh is not manifold", "face " + std::to_string(face), why);
}

}  // namespace

TriangleMesh::TriangleMesh(std::vector<Vec3> positions, std::vector<Triangle> triangles,
                           Period period)
    : positions_(std::move(positions)), triangles_(std::move(triangles)), period_(period) {
  const std::int32_t halfedges = 3 * face_count();
  opposite_.assign(halfedges, border);
  first_halfedge_.assign(positions_.size(), -1);
  source_face_.resize(triangles_.size());
  root_.resize(positions_.size());
  anchor_.assign(positions_.size(), -1);
  pinned_.assign(positions_.size(), 0);
  std::iota(source_face_.begin(), source_face_.end(), 0);
  std::iota(root_.begin(), root_.end(), 0);

  for (std::int32_t h = 0; h < halfedges; ++h) {
    const std::int32_t a = from(h);
    if (a < 0 || a >= vertex_count()) fail(face_of(h), "a corner is not a vertex");
    if (a == to(h)) fail(face_of(h), "a corner is repeated");
  }
  const std::vector<std::int32_t> sorted = sorted_halfedges(triangles_, positions_.size());
  for (std::size_t i = 0, j; i < sorted.size(); i = j) {
    const VertexPair edge = vertices_of(triangles_, sorted[i]);
    for (j = i + 1; j < sorted.size() && vertices_of(triangles_, sorted[j]) == edge;) ++j;
    if (j - i > 2) fail(face_of(sorted[i]), "an edge has more than two faces");
    if (j - i == 2) {
      const std::int32_t g = sorted[i], h = sorted[i + 1];
      if (from(g) == from(h)) fail(face_of(h), "neighbouring faces are oriented differently");
      opposite_[g] = h;
      opposite_[h] = g;
    }
  }

  std::vector<std::int32_t> corners(positions_.size(), 0);
  for (std::int32_t h = 0; h < halfedges; ++h) {
    const std::int32_t v = from(h);
    ++corners[v];
    if (first_halfedge_[v] < 0 || is_open(h)) first_halfedge_[v] = h;
  }
  for (std::int32_t v = 0; v < vertex_count(); ++v) {
    std::int32_t reached = 0;
    for_each_outgoing(v, [&](std::int32_t) { ++reached; });
    if (reached != corners[v]) {
      fail(face_of(first_halfedge_[v]), "vertex " + std::to_string(v) + " has more than one fan");
    }
  }
}

void TriangleMesh::be_own_source() {
  std::iota(source_face_.begin(), source_face_.end(), 0);
  anchor_.assign(anchor_.size(), -1);
}

double TriangleMesh::area(std::int32_t f) const {
  const Triangle& t = triangles_[f];
  return 0.5 * way(t[0], t[1]).cross(way(t[0], t[2])).norm();
}

double TriangleMesh::total_area() const {
  double sum = 0;
  for (std::int32_t f = 0; f < face_count(); ++f) sum += area(f);
  return sum;
}

TriangleMesh::Split TriangleMesh::split_edge(std::int32_t h, double t) {
  const std::int32_t a = from(h), b = to(h), o = opposite_[h];
  const std::int32_t x = vertex_count();
  positions_.push_back((1 - t) * positions_[a] + t * position_near(b, positions_[a]));
  root_.push_back(x);
  const bool slid = anchor_[a] >= 0 || anchor_[b] >= 0, pinned = is_pinned(a) && is_pinned(b);
  anchor_.push_back(slid && !pinned ? source_face_[face_of(h)] : -1);
  pinned_.push_back(pinned ? 1 : 0);
  first_halfedge_.push_back(-1);

  Split split{x, {face_of(h), -1}, {-1, -1}};
  // Shortens the face of g = (p → q) to end at x and appends the half (x, q, apex). Returns the
  // halfedge x → q; g itself becomes p → x. The new half's corner 0 is x.
  const auto halve = [&](std::int32_t g) {
    const std::int32_t f = face_of(g), q = to(g), apex = from(prev(g)), side = next(g);
    const std::int32_t half = face_count();
    triangles_.push_back({x, q, apex});
    source_face_.push_back(source_face_[f]);
    triangles_[f][side % 3] = x;
    const std::int32_t outer = opposite_[side];
    opposite_.insert(opposite_.end(), {border, outer, side});
    if (outer >= 0) opposite_[outer] = 3 * half + 1;
    opposite_[side] = 3 * half + 2;
    if (first_halfedge_[q] == side) first_halfedge_[q] = 3 * half + 1;
    return 3 * half;
  };
  const std::int32_t xb = halve(h);
  split.new_face[0] = face_of(xb);
  if (o < 0) {
    opposite_[xb] = o;
    first_halfedge_[x] = xb;
    return split;
  }
  // o runs b → a; after halving, o is b → x and its new half starts x → a.
  const std::int32_t xa = halve(o);
  split.face[1] = face_of(o);
  split.new_face[1] = face_of(xa);
  opposite_[h] = xa;
  opposite_[xa] = h;
  opposite_[o] = xb;
  opposite_[xb] = o;
  first_halfedge_[x] = xb;
  return split;
}

void TriangleMesh::slide(std::int32_t h, double t) {
  const std::int32_t v = from(h);
  positions_[v] = (1 - t) * positions_[v] + t * position_near(to(h), positions_[v]);
  anchor_[v] = source_face_[face_of(h)];
}

TriangleMesh::Cut TriangleMesh::cut(std::int32_t h, std::int32_t crack) {
  const std::int32_t o = opposite_[h], a = from(h), b = to(h);
  const bool a_open = is_open_vertex(a), b_open = is_open_vertex(b);
  opposite_[h] = opposite_[o] = -2 - crack;
  return {separate(a, h, a_open), separate(b, o, b_open)};
}

std::int32_t TriangleMesh::separate(std::int32_t v, std::int32_t fan_start, bool was_open) {
  if (!was_open) {
    first_halfedge_[v] = fan_start;
    return -1;
  }
  const std::int32_t copy = vertex_count();
  positions_.push_back(Vec3(positions_[v]));
  root_.push_back(std::int32_t{root_[v]});
  anchor_.push_back(std::int32_t{anchor_[v]});
  pinned_.push_back(char{pinned_[v]});
  first_halfedge_.push_back(fan_start);
  for (std::int32_t h = fan_start; h >= 0; h = rotate(h)) triangles_[h / 3][h % 3] = copy;
  return copy;
}

void TriangleMesh::renumber(const Numbering& numbering) {
  const auto [vertices, faces] = inverse(numbering);
  const auto halfedge = [&faces = faces](std::int32_t h) {
    return h < 0 ? h : 3 * new_number(faces, h / 3) + h % 3;
  };
  for (Triangle& t : triangles_) {
    for (std::int32_t& v : t) v = new_number(vertices, v);
  }
  for (std::int32_t& v : root_) v = new_number(vertices, v);
  for (std::int32_t& h : opposite_) h = halfedge(h);
  for (std::int32_t& h : first_halfedge_) h = halfedge(h);
  for (std::int32_t& f : source_face_) f = new_number(faces, f);
  for (std::int32_t& f : anchor_) f = new_number(faces, f);
  reorder(positions_, numbering.vertices);
  reorder(root_, numbering.vertices);
  reorder(first_halfedge_, numbering.vertices);
  reorder(anchor_, numbering.vertices);
  reorder(pinned_, numbering.vertices);
  reorder(triangles_, numbering.faces);
  reorder(source_face_, numbering.faces);
  reorder(opposite_, numbering.faces, 3);
}

void TriangleMesh::shrink_to_fit() {
  positions_.shrink_to_fit();
  triangles_.shrink_to_fit();
  for (auto* numbers : {&opposite_, &first_halfedge_, &source_face_, &root_, &anchor_}) {
    numbers->shrink_to_fit();
  }
  pinned_.shrink_to_fit();
}

}  // namespace craze
