#include "craze/engine/roughness/crack_chains.h"

#include <utility>

namespace craze {

namespace {

class ChainFinder {
 public:
  explicit ChainFinder(const CrackNetwork& network)
      : network_(network), at_(network.nodes.size()), seen_(network.edges.size(), 0) {
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
      at_[network.edges[e].a].push_back(static_cast<std::int32_t>(e));
      at_[network.edges[e].b].push_back(static_cast<std::int32_t>(e));
    }
  }

  std::vector<CrackChain> run() {
    for (const bool rings : {false, true}) {
      for (std::size_t n = 0; n < at_.size(); ++n) {
        const auto node = static_cast<std::int32_t>(n);
        if (!rings && goes_on(node)) continue;
        for (const std::int32_t e : at_[n]) {
          if (seen_[e] == 0) follow(node, e);
        }
      }
    }
    return std::move(chains_);
  }

 private:
  bool goes_on(std::int32_t node) const {
    return at_[node].size() == 2 && network_.nodes[node].kind == JunctionKind::bend;
  }

  void follow(std::int32_t node, std::int32_t edge) {
    CrackChain chain;
    chain.nodes.push_back(node);
    for (;;) {
      seen_[edge] = 1;
      const CrackEdge& e = network_.edges[edge];
      node = e.a == node ? e.b : e.a;
      chain.nodes.push_back(node);
      chain.edges.push_back(edge);
      chain.length += network_.length(e);
      if (!goes_on(node)) break;
      const std::int32_t next = at_[node][0] == edge ? at_[node][1] : at_[node][0];
      if (seen_[next] != 0) break;
      edge = next;
    }
    chains_.push_back(std::move(chain));
  }

  const CrackNetwork& network_;
  std::vector<std::vector<std::int32_t>> at_;  // per node: its edges
  std::vector<char> seen_;
  std::vector<CrackChain> chains_;
};

}  // namespace

std::vector<CrackChain> crack_chains(const CrackNetwork& network) {
  return ChainFinder(network).run();
}

double usual_length(const std::vector<CrackChain>& chains) {
  double sum = 0, squares = 0;
  for (const CrackChain& chain : chains) {
    sum += chain.length;
    squares += chain.length * chain.length;
  }
  return sum > 0 ? squares / sum : 0;
}

ChainLine::ChainLine(const CrackChain& chain, const CrackNetwork& network) {
  for (const std::int32_t n : chain.nodes) {
    const CrackNode& node = network.nodes[n];
    const Vec3 p =
        points_.empty() ? node.position : network.period.nearest(node.position, points_.back());
    arc_.push_back(points_.empty() ? 0 : arc_.back() + (p - points_.back()).norm());
    points_.push_back(p);
    normals_.push_back(node.normal);
  }
}

ChainPlace ChainLine::at(double s) const {
  const auto after = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - arc_.begin()) - 1;
  const double step = arc_[i + 1] - arc_[i];
  const double t = step > 0 ? std::clamp((s - arc_[i]) / step, 0.0, 1.0) : 0;
  return {(1 - t) * points_[i] + t * points_[i + 1],
          ((1 - t) * normals_[i] + t * normals_[i + 1]).stableNormalized(), i};
}

}  // namespace craze
