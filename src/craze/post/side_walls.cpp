#include "craze/post/side_walls.h"

#include <set>
#include <utility>

namespace craze {

SideWalls side_walls(const TriangleMesh& mesh, const CrackSites& sites,
                     const std::vector<Vec3>& normals, double depth) {
  SideWalls walls;
  std::vector<std::int32_t> bottom_of(sites.vertex.size(), -1);
  const auto bottom = [&](std::int32_t site) {
    if (bottom_of[site] < 0) {
      const std::int32_t v = sites.vertex[site];
      bottom_of[site] = mesh.vertex_count() + static_cast<std::int32_t>(walls.bottom.size());
      walls.bottom.push_back(mesh.position(v) - depth * normals[v]);
      walls.site.push_back(site);
    }
    return bottom_of[site];
  };
  // An edge between two tips cannot open: both of its sides run between the same two vertices.
  std::set<std::pair<std::int32_t, std::int32_t>> ends;
  for (const std::int32_t h : sites.sides) ends.emplace(mesh.from(h), mesh.to(h));

  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    const std::int32_t a = mesh.from(sites.sides[i]), b = mesh.to(sites.sides[i]);
    if (ends.count({b, a})) continue;
    std::int32_t below = bottom(sites.site_of[a]);
    walls.triangles.push_back({b, a, below});
    const auto down_to = [&](std::int32_t site) {
      walls.triangles.push_back({b, below, bottom(site)});
      below = bottom(site);
    };
    for (std::int32_t k = sites.first[i]; k < sites.first[i + 1]; ++k) down_to(sites.inner[k]);
    down_to(sites.site_of[b]);
  }
  return walls;
}

}  // namespace craze
