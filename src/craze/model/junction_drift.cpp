#include "craze/model/junction_drift.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace craze {

namespace {

using Links = std::vector<std::vector<std::int32_t>>;  // per node, its edges

Links links_of(const CrackNetwork& network) {
  Links links(network.nodes.size());
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    links[network.edges[e].a].push_back(static_cast<std::int32_t>(e));
    links[network.edges[e].b].push_back(static_cast<std::int32_t>(e));
  }
  return links;
}

bool is_inside_crack(const CrackNetwork& network, const Links& links, std::int32_t v) {
  return links[v].size() == 2 && network.nodes[v].kind == JunctionKind::bend;
}

// Adds a chain of nodes in pieces of equal length, close to `step`; its ends are in `made` already.
void add_chain(const CrackNetwork& network, const std::vector<std::int32_t>& chain, double step,
               std::int32_t first, std::int32_t last, CrackNetwork& made) {
  std::vector<double> arc(chain.size(), 0);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    arc[i] = arc[i - 1] + network.way(chain[i - 1], chain[i]).norm();
  }
  const auto pieces = static_cast<std::int64_t>(std::llround(arc.back() / step));
  const std::int64_t count = std::max<std::int64_t>(pieces, first == last ? 3 : 1);
  std::int32_t before = first;
  std::size_t i = 0;
  for (std::int64_t k = 1; k < count; ++k) {
    const double s = arc.back() * static_cast<double>(k) / static_cast<double>(count);
    while (arc[i + 1] < s) ++i;
    const double t = (s - arc[i]) / (arc[i + 1] - arc[i]);
    const CrackNode &a = network.nodes[chain[i]], &b = network.nodes[chain[i + 1]];
    CrackNode node;
    node.position = (1 - t) * a.position + t * network.period.nearest(b.position, a.position);
    node.normal = ((1 - t) * a.normal + t * b.normal).normalized();
    made.nodes.push_back(node);
    const auto now = static_cast<std::int32_t>(made.nodes.size() - 1);
    made.edges.push_back({before, now});
    before = now;
  }
  made.edges.push_back({before, last});
}

CrackNetwork in_equal_pieces(const CrackNetwork& network, double step) {
  const Links links = links_of(network);
  CrackNetwork made;
  made.period = network.period;
  std::vector<std::int32_t> image(network.nodes.size(), -1);
  const auto add_node = [&](std::int32_t v) {
    if (image[v] >= 0) return image[v];
    made.nodes.push_back(network.nodes[v]);
    return image[v] = static_cast<std::int32_t>(made.nodes.size() - 1);
  };
  std::vector<char> walked(network.edges.size(), 0);
  const auto walk = [&](std::int32_t start) {
    for (const std::int32_t first : links[start]) {
      if (walked[first]) continue;
      std::vector<std::int32_t> chain{start};
      std::int32_t e = first;
      for (;;) {
        walked[e] = 1;
        const CrackEdge& edge = network.edges[e];
        const std::int32_t v = edge.a == chain.back() ? edge.b : edge.a;
        chain.push_back(v);
        if (v == start || !is_inside_crack(network, links, v)) break;
        e = links[v][0] == e ? links[v][1] : links[v][0];
      }
      const std::int32_t a = add_node(start), b = add_node(chain.back());
      add_chain(network, chain, step, a, b, made);
    }
  };
  const auto nodes = static_cast<std::int32_t>(network.nodes.size());
  for (std::int32_t v = 0; v < nodes; ++v) {
    if (!is_inside_crack(network, links, v)) walk(v);
  }
  for (std::int32_t v = 0; v < nodes; ++v) walk(v);  // closed cracks without a junction
  return made;
}

// Pieces of all cracks together, at most.
constexpr double most_pieces = 1e7;

}  // namespace

CrackNetwork drifted(const CrackNetwork& network, double distance) {
  assert(distance > 0);
  const double length = total_length(network);
  if (!(4 * length / distance < most_pieces)) return network;
  distance = std::min(distance, length);
  const double step = distance / 4, shortest = step / 2;
  CrackNetwork moved = in_equal_pieces(network, step);
  const Links links = links_of(moved);
  const int rounds = 80;
  const double dt = distance * distance / 2 / rounds;  // 0.1 step²: stable on pieces of `shortest`
  std::vector<Vec3> velocity(moved.nodes.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t v = 0; v < moved.nodes.size(); ++v) {
      velocity[v].setZero();
      if (links[v].size() < 2 || moved.nodes[v].kind == JunctionKind::border) continue;
      double half_length = 0;
      for (const std::int32_t e : links[v]) {
        const CrackEdge& edge = moved.edges[e];
        const std::int32_t w = edge.a == static_cast<std::int32_t>(v) ? edge.b : edge.a;
        const Vec3 d = moved.way(static_cast<std::int32_t>(v), w);
        const double apart = d.norm();
        velocity[v] += d / std::max(apart, shortest);
        half_length += apart / 2;
      }
      velocity[v] -= velocity[v].dot(moved.nodes[v].normal) * moved.nodes[v].normal;
      velocity[v] /= std::max(half_length, shortest);
    }
    for (std::size_t v = 0; v < moved.nodes.size(); ++v) {
      moved.nodes[v].position += dt * velocity[v];
    }
  }
  return moved;
}

}  // namespace craze
