// Triangles with adjacency, made to be cut: the mesh that the simulation runs on.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/period.h"
#include "craze/mesh/numbering/numbering.h"
#include "craze/surface_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// Halfedge h = 3 f + i runs from corner i of face f to corner i+1 (mod 3). A vertex has one fan of
/// faces: the mesh is manifold, with or without border, at all times.
///
/// Faces are only split and vertices hardly ever move (slide), so each face is known by the input
/// triangle it came from (source_face) and any attribute of the input can be looked up for it
/// afterwards; vertices and faces are only appended, so an index stays valid for ever.
class TriangleMesh {
 public:
  /// opposite() of a halfedge on the border of the input.
  static constexpr std::int32_t border = -1;

  /// What an edge split made. Each old face was shortened in place and has one new half.
  struct Split {
    std::int32_t vertex;       ///< the new vertex
    std::int32_t face[2];      ///< the old faces: face[0] holds h; face[1] is −1 on a border
    std::int32_t new_face[2];  ///< the new half of each
  };

  /// The copies that a cut made of its ends from(h) and to(h); −1 where the end stayed whole.
  struct Cut {
    std::int32_t copy_of_from;
    std::int32_t copy_of_to;
  };

  TriangleMesh() = default;
  /// Builds the adjacency. The triangles must be manifold, consistently oriented and without
  /// repeated corners (see repair.h); throws Error(request) otherwise, naming the face.
  /// With a period all edges must be shorter than half of it.
  TriangleMesh(std::vector<Vec3> positions, std::vector<Triangle> triangles, Period period = {});

  std::int32_t vertex_count() const { return static_cast<std::int32_t>(positions_.size()); }
  std::int32_t face_count() const { return static_cast<std::int32_t>(triangles_.size()); }
  const std::vector<Vec3>& positions() const { return positions_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const Vec3& position(std::int32_t v) const { return positions_[v]; }
  const Period& period() const { return period_; }
  /// The image of v nearest to p; its position where nothing repeats.
  Vec3 position_near(std::int32_t v, const Vec3& p) const {
    return period_.nearest(positions_[v], p);
  }
  /// From v to w, the shortest way.
  Vec3 way(std::int32_t v, std::int32_t w) const {
    return period_.shortest(positions_[w] - positions_[v]);
  }
  /// Corner i of face f as seen from its corner 0.
  Vec3 corner(std::int32_t f, int i) const {
    return position_near(triangles_[f][i], positions_[triangles_[f][0]]);
  }
  const Triangle& triangle(std::int32_t f) const { return triangles_[f]; }

  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t prev(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  static std::int32_t face_of(std::int32_t h) { return h / 3; }
  std::int32_t from(std::int32_t h) const { return triangles_[h / 3][h % 3]; }
  std::int32_t to(std::int32_t h) const { return from(next(h)); }
  /// The same edge seen from the other side; negative on a border or crack (see crack_of).
  std::int32_t opposite(std::int32_t h) const { return opposite_[h]; }
  bool is_open(std::int32_t h) const { return opposite_[h] < 0; }
  /// The label given to cut() if h is a side of a crack, else −1.
  std::int32_t crack_of(std::int32_t h) const {
    return opposite_[h] < border ? -2 - opposite_[h] : -1;
  }

  /// A halfedge leaving v: the first of its fan counter-clockwise, so on an open fan the one whose
  /// edge is open. −1 for a vertex without faces.
  std::int32_t first_halfedge(std::int32_t v) const { return first_halfedge_[v]; }
  /// The next halfedge leaving the same vertex, counter-clockwise; −1 past an open fan's last.
  std::int32_t rotate(std::int32_t h) const {
    const std::int32_t o = opposite_[prev(h)];
    return o < 0 ? -1 : o;
  }
  bool is_open_vertex(std::int32_t v) const {
    return first_halfedge_[v] >= 0 && is_open(first_halfedge_[v]);
  }
  /// Calls visit(h) for the halfedges leaving v, one per face of its star, counter-clockwise.
  template <class Visit>
  void for_each_outgoing(std::int32_t v, Visit&& visit) const {
    const std::int32_t begin = first_halfedge_[v];
    if (begin < 0) return;
    std::int32_t h = begin;
    do {
      visit(h);
      h = rotate(h);
    } while (h >= 0 && h != begin);
  }

  /// The input triangle that a face is part of.
  std::int32_t source_face(std::int32_t f) const { return source_face_[f]; }
  /// From now on every face is its own source, and no vertex is anchored.
  void be_own_source();
  /// The vertex that v was separated from, the first of its line; v itself otherwise. Copies have
  /// the same position.
  std::int32_t root(std::int32_t v) const { return root_[v]; }

  /// The input triangle in which a vertex that has slid takes its attributes, the same for all its
  /// faces; −1: in each face's own source_face.
  std::int32_t anchor(std::int32_t v) const { return anchor_[v]; }
  /// Whether v must stay where it is, since it marks a fold or seam. Splitting an edge between two
  /// pinned vertices makes a pinned one.
  bool is_pinned(std::int32_t v) const { return pinned_[v] != 0; }
  void pin(std::int32_t v) { pinned_[v] = 1; }

  double area(std::int32_t f) const;
  double total_area() const;

  /// Splits edge h at position (1−t) from(h) + t to(h), 0 < t < 1, and both its faces with it. A
  /// side of a crack or border splits only its own face; its label passes to both halves.
  Split split_edge(std::int32_t h, double t);

  /// Opens the interior edge h: both sides become open, labelled with `crack` (≥ 0). An end whose
  /// star falls into two fans is separated: the fan that starts with the cut gets a copy of the
  /// vertex, at the same position. An end in the middle of the surface stays one vertex, a tip.
  Cut cut(std::int32_t h, std::int32_t crack);

  /// Moves the origin of the interior halfedge h to (1−t) from(h) + t to(h), which lies on h's
  /// face. It must be neither open nor pinned. The caller sees to it that no face of its star turns
  /// over.
  void slide(std::int32_t h, double t);

  /// Gives everything its new number; the faces that sources and anchors name too.
  void renumber(const Numbering& numbering);

  /// Gives back the memory that was kept for more edits.
  void shrink_to_fit();

 private:
  std::int32_t separate(std::int32_t v, std::int32_t fan_start, bool was_open);

  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<std::int32_t> opposite_;        // 3 #F; −1 border, −2−c a side of crack c
  std::vector<std::int32_t> first_halfedge_;  // #V
  std::vector<std::int32_t> source_face_;     // #F
  std::vector<std::int32_t> root_;            // #V
  std::vector<std::int32_t> anchor_;          // #V
  std::vector<char> pinned_;                  // #V
  Period period_;
};

}  // namespace craze
