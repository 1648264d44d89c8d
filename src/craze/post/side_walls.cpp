#include "craze/post/side_walls.h"

#include <set>
#include <utility>

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
  void build(std::int32_t h, const std::vector<std::int32_t>& inner) {
    const std::int32_t a = mesh_.from(h), b = mesh_.to(h);
    std::int32_t below = bottom(a);
    walls_.triangles.push_back({b, a, below});
    const auto down_to = [&](std::int32_t v) {
      const std::int32_t next = bottom(v);
      walls_.triangles.push_back({b, below, next});
      below = next;
    };
    for (const std::int32_t v : inner) down_to(v);
    down_to(b);
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
  for (const std::int32_t h : sites.sides) ends.emplace(mesh.from(h), mesh.to(h));

  WallBuilder builder(mesh, sites, normals, depth);
  std::vector<std::int32_t> inner;
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    const std::int32_t h = sites.sides[i];
    if (ends.count({mesh.to(h), mesh.from(h)})) continue;
    inner.clear();
    for (std::int32_t k = sites.first[i]; k < sites.first[i + 1]; ++k) {
      inner.push_back(sites.vertex[sites.inner[k]]);
    }
    builder.build(h, inner);
  }
  for (std::int32_t h = 0; along_border && h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) == TriangleMesh::border) builder.build(h, {});
  }
  return builder.take();
}

}  // namespace craze
