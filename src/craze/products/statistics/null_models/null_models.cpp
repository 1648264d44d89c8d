#include "craze/products/statistics/null_models/null_models.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "craze/error.h"
#include "craze/products/statistics/null_models/null_networks.h"

namespace craze {

std::string_view to_string(NullModel model) {
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

CrackGraphInput null_graph(const std::string& text) {
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorKind::usage, "unknown null model", text, why);
  };
  const std::string label = text.substr(0, text.find('?'));
  const auto* model = std::find_if(std::begin(all_null_models), std::end(all_null_models),
                                   [&](NullModel m) { return to_string(m) == label; });
  if (model == std::end(all_null_models)) {
    fail("it must be voronoi, orthogonal, stit, square, hexagonal or brick");
  }
  std::int32_t cells = 2000;
  std::uint64_t seed = 1;
  for (std::size_t at = text.find_first_of("?&"); at != std::string::npos;) {
    const std::size_t end = text.find('&', at + 1);
    const std::string pair = text.substr(at + 1, end == std::string::npos ? end : end - at - 1);
    const std::size_t equals = pair.find('=');
    const std::string digits = equals == std::string::npos ? "" : pair.substr(equals + 1);
    if (digits.empty() || digits.size() > 18 ||
        digits.find_first_not_of("0123456789") != std::string::npos) {
      fail("write NAME?cells=N&seed=S with whole numbers");
    }
    const std::uint64_t number = std::stoull(digits);
    if (pair.starts_with("cells=") && number >= 1 && number <= 1000000) {
      cells = static_cast<std::int32_t>(number);
    } else if (pair.starts_with("seed=")) {
      seed = number;
    } else {
      fail("it takes cells (1 to 1000000) and seed");
    }
    at = end;
  }
  return null_graph(*model, cells, seed);
}

}  // namespace craze
