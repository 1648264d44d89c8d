#include "craze/stats/null_models.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "craze/stats/null_networks.h"

namespace craze {

std::string_view name(NullModel model) {
  constexpr std::string_view names[] = {"voronoi", "orthogonal", "stit",
                                        "square",  "hexagonal",  "brick"};
  return names[static_cast<int>(model)];
}

CrackNetwork null_network(NullModel model, std::int32_t cells, std::uint64_t seed) {
  const double side = std::sqrt(static_cast<double>(cells));
  switch (model) {
    case NullModel::poisson_voronoi:
      return voronoi_network(side, seed);
    case NullModel::orthogonal_splitting:
      return orthogonal_network(side, cells, orthogonal_cut[0], orthogonal_cut[1], seed);
    case NullModel::stit:
      return stit_network(side, cells, seed);
    case NullModel::square:
      return lattice_network(Lattice::square, side);
    case NullModel::hexagonal:
      return lattice_network(Lattice::hexagonal, side);
    case NullModel::brick:
      return lattice_network(Lattice::brick, side);
  }
  return {};
}

CrackGraphInput graph_in_square(const CrackNetwork& network, double side) {
  CrackGraphInput graph;
  // Border nodes by their way along each side of the window.
  std::vector<std::pair<double, std::int32_t>> along[4];
  for (const CrackNode& node : network.nodes) {
    const auto id = static_cast<std::int32_t>(graph.points.size());
    graph.points.push_back(node.position);
    if (node.kind != JunctionKind::border) continue;
    const double x = node.position.x(), y = node.position.y();
    const double gap[4] = {y, side - x, side - y, x};
    const double way[4] = {x, y, side - x, side - y};
    int nearest = 0;
    for (int s = 1; s < 4; ++s) {
      if (std::abs(gap[s]) < std::abs(gap[nearest])) nearest = s;
    }
    along[nearest].emplace_back(way[nearest], id);
  }
  const Vec3 corners[4] = {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}};
  const auto first_corner = static_cast<std::int32_t>(graph.points.size());
  graph.points.insert(graph.points.end(), corners, corners + 4);
  graph.normals.assign(graph.points.size(), Vec3::UnitZ());
  for (int s = 0; s < 4; ++s) {
    std::sort(along[s].begin(), along[s].end());
    along[s].emplace_back(side, first_corner + (s + 1) % 4);
    std::int32_t last = first_corner + s;
    for (const auto& [way, id] : along[s]) {
      GraphInputEdge edge;
      edge.a = std::exchange(last, id);
      edge.b = id;
      edge.border = true;
      graph.edges.push_back(edge);
    }
  }
  for (const CrackEdge& crack : network.edges) {
    GraphInputEdge edge;
    edge.a = crack.a;
    edge.b = crack.b;
    edge.time = crack.time;
    edge.event = crack.event;
    graph.edges.push_back(edge);
  }
  graph.surface_area = side * side;
  return graph;
}

CrackGraphInput null_graph(NullModel model, std::int32_t cells, std::uint64_t seed) {
  return graph_in_square(null_network(model, cells, seed), std::sqrt(static_cast<double>(cells)));
}

}  // namespace craze
