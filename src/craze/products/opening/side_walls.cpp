#include "craze/products/opening/side_walls.h"

#include <set>
#include <utility>

#include "craze/products/opening/wall_fans.h"

namespace craze {

namespace {

class WallBuilder {
 public:
  WallBuilder(const TriangleMesh& mesh, const CrackSites& sites, const std::vector<Vec3>& normals,
              double depth)
      : mesh_(mesh),
        sites_(sites),
        normals_(normals),
        depth_(depth),
        bottom_of_(mesh.vertex_count(), -1) {}

  /// A wall under the open halfedge h. `inner`: vertices inside its bottom edge, in its direction.
  /// Its upper ends a and b fan out over the bottom: a over the first `from_start` edges, b over
  /// the rest.
  void build(std::int32_t h, const std::vector<std::int32_t>& inner, std::size_t from_start) {
    const std::int32_t a = mesh_.from(h), b = mesh_.to(h);
    std::vector<std::int32_t> bottoms{bottom(a)};
    for (const std::int32_t v : inner) bottoms.push_back(bottom(v));
    bottoms.push_back(bottom(b));
    for (std::size_t i = 0; i + 1 < bottoms.size(); ++i) {
      if (i == from_start) walls_.triangles.push_back({a, bottoms[i], b});
      walls_.triangles.push_back({i < from_start ? a : b, bottoms[i], bottoms[i + 1]});
    }
    if (from_start + 1 == bottoms.size()) walls_.triangles.push_back({a, bottoms.back(), b});
    walls_.beside.resize(walls_.triangles.size(), TriangleMesh::face_of(h));
  }

  SideWalls take() { return std::move(walls_); }

 private:
  std::int32_t bottom(std::int32_t v) {
    if (sites_.site_of[v] >= 0) v = sites_.vertex[sites_.site_of[v]];
    if (bottom_of_[v] < 0) {
      bottom_of_[v] = mesh_.vertex_count() + static_cast<std::int32_t>(walls_.bottom.size());
      walls_.bottom.push_back(mesh_.position(v) - depth_ * normals_[v]);
      walls_.vertex.push_back(v);
    }
    return bottom_of_[v];
  }

  const TriangleMesh& mesh_;
  const CrackSites& sites_;
  const std::vector<Vec3>& normals_;
  double depth_;
  std::vector<std::int32_t> bottom_of_;  // per vertex that stands for its site
  SideWalls walls_;
};

}  // namespace

SideWalls side_walls(const TriangleMesh& mesh, const CrackSites& sites,
                     const std::vector<Vec3>& normals, double depth, bool along_border) {
  // An edge between two tips cannot open: both of its sides run between the same two vertices.
  std::set<std::pair<std::int32_t, std::int32_t>> ends;
  // Where sides start and end: (vertex, the site next to it on the side).
  std::set<std::pair<std::int32_t, std::int32_t>> starts_at, ends_at;
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    const std::int32_t a = mesh.from(sites.sides[i]), b = mesh.to(sites.sides[i]);
    ends.emplace(a, b);
    starts_at.emplace(a, sites.after_from(mesh, i));
    ends_at.emplace(b, sites.before_to(mesh, i));
  }

  const std::vector<std::size_t> fans = wall_fans(mesh, sites);
  WallBuilder builder(mesh, sites, normals, depth);
  std::vector<std::int32_t> inner;
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    const std::int32_t h = sites.sides[i], a = mesh.from(h), b = mesh.to(h);
    if (ends.count({b, a})) continue;
    inner.clear();
    for (std::int32_t k = sites.first[i]; k < sites.first[i + 1]; ++k) {
      inner.push_back(sites.vertex[sites.inner[k]]);
    }
    // Not from a tip, which is the same vertex for both sides.
    const bool a_is_tip = ends_at.count({a, sites.after_from(mesh, i)}) > 0;
    const bool b_is_tip = starts_at.count({b, sites.before_to(mesh, i)}) > 0;
    std::size_t from_start = fans[i];
    if (a_is_tip) from_start = 0;
    if (b_is_tip) from_start = inner.size() + 1;
    builder.build(h, inner, from_start);
  }
  for (std::int32_t h = 0; along_border && h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) == TriangleMesh::border) builder.build(h, {}, 0);
  }
  return builder.take();
}

}  // namespace craze
