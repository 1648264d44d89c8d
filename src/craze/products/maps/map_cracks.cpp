#include "craze/products/maps/map_cracks.h"

namespace craze {

namespace {

/// Cosine of the largest bend at which a crack goes on through a junction.
constexpr double straight_on = -0.866;

/// The network's edges keep one width each. At a node an edge takes the mean of its own and that of
/// the edge that goes on straightest; a tip is shut.
class WidthsAtNodes {
 public:
  explicit WidthsAtNodes(const CrackNetwork& network) : network_(network) {
    at_.resize(network.nodes.size());
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
      at_[network.edges[e].a].push_back(static_cast<std::int32_t>(e));
      at_[network.edges[e].b].push_back(static_cast<std::int32_t>(e));
    }
  }

  double operator()(std::int32_t edge, std::int32_t node) const {
    const double own = network_.edges[edge].width;
    if (network_.nodes[node].kind == JunctionKind::end) return 0;
    const Vec3 away = direction(edge, node);
    double best = straight_on, width = own;
    for (const std::int32_t other : at_[node]) {
      const double cosine = direction(other, node).dot(away);
      if (other == edge || cosine >= best) continue;
      best = cosine;
      width = (own + network_.edges[other].width) / 2;
    }
    return width;
  }

 private:
  Vec3 direction(std::int32_t edge, std::int32_t node) const {
    const CrackEdge& e = network_.edges[edge];
    const std::int32_t other = e.a == node ? e.b : e.a;
    return network_.way(node, other).stableNormalized();
  }

  const CrackNetwork& network_;
  std::vector<std::vector<std::int32_t>> at_;  // per node: its edges
};

}  // namespace

std::vector<MapCrack> map_cracks(const CrackNetwork& network) {
  std::vector<MapCrack> cracks;
  const WidthsAtNodes width(network);
  for (std::size_t i = 0; i < network.edges.size(); ++i) {
    const CrackEdge& e = network.edges[i];
    const auto edge = static_cast<std::int32_t>(i);
    cracks.push_back({network.nodes[e.a].position,
                      network.nodes[e.b].position,
                      {width(edge, e.a), width(edge, e.b)},
                      e.time,
                      e.event,
                      e.face});
  }
  return cracks;
}

}  // namespace craze
