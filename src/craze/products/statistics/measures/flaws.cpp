#include "craze/products/statistics/measures/flaws.h"

namespace craze {
namespace {

/// Per node: the total length of the cracks connected to it, infinite where that reaches a border.
std::vector<double> connected_length(const CrackGraph& graph) {
  std::vector<double> length(graph.nodes().size(), -1);
  for (std::size_t start = 0; start < length.size(); ++start) {
    if (length[start] >= 0) continue;
    std::vector<std::int32_t> component{static_cast<std::int32_t>(start)};
    length[start] = 0;
    double sum = 0;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const auto& node = graph.nodes()[component[i]];
      if (node.border) sum = std::numeric_limits<double>::infinity();
      for (const Dart d : node.darts) {
        sum += graph.edges()[d / 2].length / 2;  // met once from each end
        const std::int32_t next = graph.target(d);
        if (length[next] >= 0) continue;
        length[next] = 0;
        component.push_back(next);
      }
    }
    for (const std::int32_t n : component) length[n] = sum;
  }
  return length;
}

}  // namespace

Flaws measure_flaws(const CrackGraph& graph, double spacing, const std::vector<char>& ignored) {
  const std::vector<double> connected = connected_length(graph);
  std::vector<double> length, dead_end, spur, micro;
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const auto id = static_cast<std::int32_t>(e);
    if (!graph.is_alive(id) || graph.edges()[e].border) continue;
    const double l = graph.edges()[e].length;
    int tips = 0;
    for (const std::int32_t n : {graph.origin(2 * id), graph.target(2 * id)}) {
      tips += graph.is_tip(n) && !ignored[n];
    }
    const bool alone = connected[graph.origin(2 * id)] < spacing / 4;
    length.push_back(l);
    dead_end.push_back(tips > 0 ? l : 0);
    spur.push_back(tips > 0 && !alone && l < spacing / 4 ? l : 0);
    micro.push_back(alone ? l : 0);
  }
  return {ratio_of(dead_end, length), ratio_of(spur, length), ratio_of(micro, length)};
}

}  // namespace craze
