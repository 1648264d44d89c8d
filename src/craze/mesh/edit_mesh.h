// Triangles with adjacency, made to be remeshed: edges split, collapse and flip.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Like TriangleMesh, halfedge 3f+i runs from corner i to corner i+1 of face f. Every edit keeps
/// the surface manifold and its topology. Removed faces stay as holes in the numbering (is_face)
/// until compact() is asked for. Each edge carries a mark that passes to its parts; 0 is free to
/// flip, anything else is kept as a line.
class EditMesh {
 public:
  /// A copy of `mesh`, which has no cracks. marks: 3 #F, the same on both sides of an edge.
  EditMesh(const TriangleMesh& mesh, std::vector<char> marks);

  std::int32_t vertex_count() const { return static_cast<std::int32_t>(positions_.size()); }
  std::int32_t face_slots() const { return static_cast<std::int32_t>(triangles_.size()); }
  std::int32_t halfedge_slots() const { return 3 * face_slots(); }
  bool is_face(std::int32_t f) const { return triangles_[f][0] >= 0; }
  bool is_vertex(std::int32_t v) const { return first_[v] >= 0; }
  const Triangle& triangle(std::int32_t f) const { return triangles_[f]; }
  const Vec3& position(std::int32_t v) const { return positions_[v]; }
  /// The image of v nearest to p; its position where nothing repeats.
  Vec3 position_near(std::int32_t v, const Vec3& p) const {
    return period_.nearest(positions_[v], p);
  }
  const Period& period() const { return period_; }
  void move(std::int32_t v, const Vec3& p) { positions_[v] = p; }

  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t prev(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::int32_t from(std::int32_t h) const { return triangles_[h / 3][h % 3]; }
  std::int32_t to(std::int32_t h) const { return from(next(h)); }
  std::int32_t apex(std::int32_t h) const { return from(prev(h)); }
  /// −1 on a border.
  std::int32_t opposite(std::int32_t h) const { return opposite_[h]; }
  char mark(std::int32_t h) const { return marks_[h]; }
  /// One of the two sides stands for the edge.
  bool is_edge(std::int32_t h) const { return is_face(h / 3) && opposite_[h] < h; }

  /// Asks for the face beyond h, or for the corners of that and its own, some time before.
  void prefetch_face_beyond(std::int32_t h) const {
    if (opposite_[h] >= 0) __builtin_prefetch(&triangles_[opposite_[h] / 3]);
  }
  void prefetch_corners(std::int32_t h) const {
    for (const std::int32_t v : triangles_[h / 3]) prefetch_position(v);
    if (opposite_[h] >= 0) prefetch_position(apex(opposite_[h]));
  }

  /// The halfedges leaving v, one per face of its star, counter-clockwise.
  template <class Visit>
  void for_each_outgoing(std::int32_t v, Visit&& visit) const {
    const std::int32_t begin = first_[v];
    for (std::int32_t h = begin; h >= 0;) {
      visit(h);
      h = opposite_[prev(h)];
      if (h == begin) return;
    }
  }
  bool is_border_vertex(std::int32_t v) const { return opposite_[first_[v]] < 0; }
  bool are_neighbours(std::int32_t v, std::int32_t w) const;
  /// How many marked edges meet at v.
  int count_marked(std::int32_t v) const { return on_line_[v] ? count_marked_around(v) : 0; }

  /// Puts a vertex at p on edge h; returns it. h then runs from(h) → new vertex.
  std::int32_t split(std::int32_t h, const Vec3& p);
  /// True if from(h) can be merged into to(h) without harm to the topology or to marked lines: only
  /// a vertex without marks, or one inside a marked line along that line, may go.
  bool can_collapse(std::int32_t h) const;
  /// The part of that which is about marks.
  bool marks_allow_collapse(std::int32_t h) const;
  /// Merges from(h) into to(h), which stays where it is. Needs can_collapse(h).
  void collapse(std::int32_t h);
  /// True if the edge has two faces, no mark, and the other diagonal does not exist already.
  bool can_flip(std::int32_t h) const;
  /// Replaces the edge by the other diagonal of its two faces. Needs can_flip(h).
  void flip(std::int32_t h);

  /// The triangles that are left, on the vertices that are left; `kept` receives, for each of
  /// these vertices, its index before.
  std::vector<Triangle> compact(std::vector<std::int32_t>& kept) const;

 private:
  int count_marked_around(std::int32_t v) const;
  void prefetch_position(std::int32_t v) const {
    if (v < 0) return;  // of a removed face
    const char* begin = reinterpret_cast<const char*>(&positions_[v]);
    __builtin_prefetch(begin);
    __builtin_prefetch(begin + sizeof(Vec3) - 1);
  }
  void link(std::int32_t g, std::int32_t h);
  void remove_face_of(std::int32_t h);
  void refresh_first(std::int32_t v, std::int32_t h);

  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;     // {−1, −1, −1}: removed
  std::vector<std::int32_t> opposite_;  // 3 #F
  std::vector<char> marks_;             // 3 #F
  std::vector<std::int32_t> first_;     // #V: starts the fan; −1: removed
  std::vector<char> on_line_;           // #V: whether marked edges may meet there
  Period period_;
};

}  // namespace craze
