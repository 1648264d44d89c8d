#include "craze/products/opening/wall_fans.h"

#include <cstdint>
#include <map>
#include <utility>

namespace craze {

namespace {

using Between = std::pair<std::int32_t, std::int32_t>;
/// Which ends of a side lie inside an edge of the other side of the crack.
struct Inside {
  bool from, to;
};

/// By the sites at the ends of a side that is part of an edge of the other side.
std::map<Between, Inside> inside_other_sides(const TriangleMesh& mesh, const CrackSites& sites) {
  std::map<Between, Inside> inside;
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    if (sites.first[i] == sites.first[i + 1]) continue;
    std::int32_t before = sites.site_of[mesh.from(sites.sides[i])];
    bool before_inside = false;
    for (std::int32_t k = sites.first[i]; k < sites.first[i + 1]; ++k) {
      inside[{sites.inner[k], before}] = {true, before_inside};
      before = sites.inner[k];
      before_inside = true;
    }
    inside[{sites.site_of[mesh.to(sites.sides[i])], before}] = {false, true};
  }
  return inside;
}

}  // namespace

std::vector<std::size_t> wall_fans(const TriangleMesh& mesh, const CrackSites& sites) {
  const std::map<Between, Inside> inside = inside_other_sides(mesh, sites);
  std::vector<std::size_t> fans;
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    const std::int32_t from = sites.site_of[mesh.from(sites.sides[i])],
                       to = sites.site_of[mesh.to(sites.sides[i])];
    const auto inner = static_cast<std::size_t>(sites.first[i + 1] - sites.first[i]);
    std::size_t fan = from > to ? inner + 1 : 0;
    const auto part = inside.find({from, to});
    if (inner > 0) {
      fan = 1;
    } else if (part != inside.end() && part->second.from != part->second.to) {
      fan = part->second.from ? 0 : inner + 1;
    }
    fans.push_back(fan);
  }
  return fans;
}

}  // namespace craze
