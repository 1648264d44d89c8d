// Which faces of a user's mesh lie side by side, whatever its vertices, seams and faults.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// A range of halfedges 3f+i, ascending.
struct HalfedgeRange {
  const std::int32_t* first;
  const std::int32_t* last;

  const std::int32_t* begin() const { return first; }
  const std::int32_t* end() const { return last; }
  std::int32_t size() const { return static_cast<std::int32_t>(last - first); }
};

/// Vertices that share a position are one `place`, so UV and normal seams that split vertices do
/// not part the surface. An edge is a pair of places, with however many faces it has: nothing need
/// be manifold or consistently oriented. Halfedge 3f+i runs from corner i to corner i+1 of face f.
/// The triangles must outlive this.
class AssetTopology {
 public:
  /// Welds equal positions. O(#V log #V + #F).
  AssetTopology(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);
  /// places: #V, for each vertex the lowest one that is the same place; each its own where vertices
  /// are joined as the surface is, which is what repair makes. O(#V + #F).
  AssetTopology(const std::vector<Triangle>& triangles, std::vector<std::int32_t> places);

  std::int32_t face_count() const { return static_cast<std::int32_t>(triangles_.size()); }
  std::int32_t vertex_count() const { return static_cast<std::int32_t>(places_.size()); }
  std::int32_t edge_count() const { return static_cast<std::int32_t>(first_side_.size()) - 1; }

  /// The place of a halfedge's origin.
  std::int32_t from(std::int32_t h) const { return places_[triangles_[h / 3][h % 3]]; }
  std::int32_t to(std::int32_t h) const { return from(h % 3 == 2 ? h - 2 : h + 1); }

  /// The edge of a halfedge; −1 where both ends are one place.
  std::int32_t edge(std::int32_t h) const { return edge_[h]; }
  /// The halfedges of an edge: one on a border, two inside, more where it is not manifold.
  HalfedgeRange sides(std::int32_t edge) const {
    return {sides_.data() + first_side_[edge], sides_.data() + first_side_[edge + 1]};
  }
  /// The halfedges that leave a place, one per corner.
  HalfedgeRange leaving(std::int32_t place) const {
    return {leaving_.data() + first_leaving_[place], leaving_.data() + first_leaving_[place + 1]};
  }

 private:
  void collect_corners();
  void collect_edges();

  const std::vector<Triangle>& triangles_;
  std::vector<std::int32_t> places_;         // #V
  std::vector<std::int32_t> edge_;           // 3 #F
  std::vector<std::int32_t> first_side_;     // #E + 1
  std::vector<std::int32_t> sides_;          // by edge
  std::vector<std::int32_t> first_leaving_;  // #V + 1
  std::vector<std::int32_t> leaving_;        // by place
};

}  // namespace craze
