#include "craze/products/maps/map_cracks.h"

namespace craze {

namespace {

/// Cosine of the largest bend at which a crack goes on through a junction.
constexpr double straight_on = -0.866;

/// What edges have at their nodes, of which the network keeps one number each.
class EdgeEnds {
 public:
  struct End {
    double width, time;
  };

  explicit EdgeEnds(const CrackNetwork& network) : network_(network) {
    at_.resize(network.nodes.size());
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
      at_[network.edges[e].a].push_back(static_cast<std::int32_t>(e));
      at_[network.edges[e].b].push_back(static_cast<std::int32_t>(e));
    }
  }

  End at(std::int32_t edge, std::int32_t node) const {
    const CrackEdge& own = network_.edges[edge];
    if (network_.nodes[node].kind == JunctionKind::end) return {0, own.time};
    const Vec3 away = direction(edge, node);
    double best = straight_on;
    End end{own.width, own.time};
    for (const std::int32_t other : at_[node]) {
      const double cosine = direction(other, node).dot(away);
      if (other == edge || cosine >= best) continue;
      best = cosine;
      const CrackEdge& onward = network_.edges[other];
      end = {(own.width + onward.width) / 2, (own.time + onward.time) / 2};
    }
    return end;
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

std::vector<MapCrack> map_cracks(const CrackNetwork& network, const TriangleMesh& mesh) {
  std::vector<MapCrack> cracks;
  const EdgeEnds ends(network);
  for (std::size_t i = 0; i < network.edges.size(); ++i) {
    const CrackEdge& e = network.edges[i];
    const auto edge = static_cast<std::int32_t>(i);
    const EdgeEnds::End a = ends.at(edge, e.a), b = ends.at(edge, e.b);
    cracks.push_back(
        {network.nodes[e.a].position,
         network.nodes[e.b].position,
         {a.width, b.width},
         e.time,
         e.event,
         e.face,
         {a.time, b.time},
         {mesh.root(network.nodes[e.a].vertex), mesh.root(network.nodes[e.b].vertex)}});
  }
  return cracks;
}

}  // namespace craze
