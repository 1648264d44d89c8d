#include "craze/products/solids/shells.h"

#include <algorithm>
#include <numeric>

namespace craze {

Shells find_shells(const TriangleMesh& mesh, const CrackSites& sites) {
  std::vector<std::int32_t> parent(mesh.vertex_count());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](std::int32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  const auto join = [&](std::int32_t v, std::int32_t w) {
    const std::int32_t a = find(v), b = find(w);
    parent[std::max(a, b)] = std::min(a, b);
  };
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (sites.site_of[v] >= 0) join(v, sites.vertex[sites.site_of[v]]);
  }
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) join(mesh.from(h), mesh.to(h));

  Shells shells;
  shells.of_vertex.assign(mesh.vertex_count(), -1);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.first_halfedge(v) < 0) continue;
    std::int32_t& number = shells.of_vertex[find(v)];
    if (number < 0) {
      number = static_cast<std::int32_t>(shells.is_closed.size());
      shells.is_closed.push_back(1);
    }
    shells.of_vertex[v] = number;
  }
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) == TriangleMesh::border) {
      shells.is_closed[shells.of_vertex[mesh.from(h)]] = 0;
    }
  }
  return shells;
}

}  // namespace craze
