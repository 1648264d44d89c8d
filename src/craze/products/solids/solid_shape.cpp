#include "craze/products/solids/solid_shape.h"

#include <algorithm>
#include <cstdint>

namespace craze {

std::vector<Vec3> SolidShape::whole() const {
  std::vector<Vec3> whole = opened;
  for (std::size_t v = 0; v < chipped.size(); ++v) whole[v] -= chipped[v];
  return whole;
}

std::vector<Vec3> SolidShape::positions(const std::vector<double>& depth) const {
  constexpr double of_depth = 0.5;
  const std::vector<Vec3> whole = this->whole();
  std::vector<Vec3> positions = opened;
  for (std::size_t v = 0; v < chipped.size(); ++v) {
    const double by = chipped[v].norm(), most = of_depth * depth[v];
    if (by > most) positions[v] = whole[v] + most / by * chipped[v];
  }
  for (std::size_t i = 0; i < topology.bottoms.size(); ++i) {
    const SolidBottom& b = topology.bottoms[i];
    const bool is_core = static_cast<std::int32_t>(i) >= topology.core_bottom;
    const std::vector<Vec3>& shut = mesh.positions();
    const std::vector<Vec3>& from = is_core ? shut : whole;
    Vec3 top = from[b.from] + b.share * (from[b.to] - from[b.from]);
    if (!is_core && wedge > 0) {
      top += std::min(wedge * depth[b.vertex], 1.0) *
             (shut[b.from] + b.share * (shut[b.to] - shut[b.from]) - top);
    }
    const double down = depth[b.vertex] + (is_core ? clearance[b.vertex] : 0);
    positions.push_back(top - down * outwards[b.vertex]);
  }
  return positions;
}

std::vector<double> largest_moves(const TriangleMesh& mesh, const CrackSites& sites,
                                  const std::vector<Vec3>& opened) {
  std::vector<double> move(opened.size()), of_site(sites.vertex.size(), 0);
  for (std::size_t v = 0; v < move.size(); ++v) {
    move[v] = (opened[v] - mesh.positions()[v]).norm();
    const std::int32_t site = sites.site_of[v];
    if (site >= 0) of_site[site] = std::max(of_site[site], move[v]);
  }
  for (std::size_t v = 0; v < move.size(); ++v) {
    if (sites.site_of[v] >= 0) move[v] = of_site[sites.site_of[v]];
  }
  return move;
}

}  // namespace craze
