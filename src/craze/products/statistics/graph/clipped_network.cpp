#include "craze/products/statistics/graph/clipped_network.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace craze {

void ClippedNetwork::add(const Key& key_a, const Vec2& a, const Key& key_b, const Vec2& b) {
  // Liang & Barsky: the part of a + t (b − a) inside all four sides.
  double enter = 0, leave = 1;
  const Vec2 d = b - a;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0) {
      if (a[axis] < 0 || a[axis] > side_) return;
      continue;
    }
    double low = -a[axis] / d[axis], high = (side_ - a[axis]) / d[axis];
    if (low > high) std::swap(low, high);
    enter = std::max(enter, low);
    leave = std::min(leave, high);
  }
  if (enter >= leave) return;
  CrackEdge edge;
  edge.a = enter > 0 ? border_node(a + enter * d) : node(key_a, a);
  edge.b = leave < 1 ? border_node(a + leave * d) : node(key_b, b);
  network_.edges.push_back(edge);
}

std::int32_t ClippedNetwork::node(const Key& key, const Vec2& p) {
  const auto [entry, inserted] =
      node_of_.try_emplace(key, static_cast<std::int32_t>(network_.nodes.size()));
  if (inserted) network_.nodes.push_back({{p.x(), p.y(), 0}, Vec3::UnitZ(), -1, {}});
  return entry->second;
}

std::int32_t ClippedNetwork::border_node(const Vec2& p) {
  network_.nodes.push_back({{p.x(), p.y(), 0}, Vec3::UnitZ(), -1, JunctionKind::border});
  return static_cast<std::int32_t>(network_.nodes.size()) - 1;
}

CrackNetwork ClippedNetwork::take() {
  set_kinds(network_);
  return std::move(network_);
}

void set_kinds(CrackNetwork& network) {
  std::vector<int> degree(network.nodes.size(), 0);
  for (const CrackEdge& e : network.edges) {
    ++degree[e.a];
    ++degree[e.b];
  }
  for (std::size_t n = 0; n < degree.size(); ++n) {
    JunctionKind& kind = network.nodes[n].kind;
    if (kind == JunctionKind::border) continue;
    kind = degree[n] == 1   ? JunctionKind::end
           : degree[n] == 2 ? JunctionKind::bend
                            : JunctionKind::junction;
  }
}

}  // namespace craze
