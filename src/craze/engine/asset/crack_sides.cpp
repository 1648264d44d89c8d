#include "craze/engine/asset/crack_sides.h"

#include <algorithm>
#include <cstddef>

#include "craze/base/segment_distance.h"

namespace craze {

namespace {

/// The edges at each node.
class NodeEdges {
 public:
  explicit NodeEdges(const CrackNetwork& network)
      : network_(network), first_(network.nodes.size() + 1, 0) {
    for (const CrackEdge& e : network.edges) {
      ++first_[e.a + 1];
      ++first_[e.b + 1];
    }
    for (std::size_t n = 0; n + 1 < first_.size(); ++n) first_[n + 1] += first_[n];
    edges_.resize(first_.back());
    std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
      edges_[next[network.edges[e].a]++] = static_cast<std::int32_t>(e);
      edges_[next[network.edges[e].b]++] = static_cast<std::int32_t>(e);
    }
  }

  /// The edge that leaves a node most nearly towards a point.
  std::int32_t towards(std::int32_t node, const Vec3& target) const {
    const Vec3& p = network_.nodes[node].position;
    const Vec3 way = (target - p).stableNormalized();
    std::int32_t best = -1;
    double most = 0;
    for (std::int32_t k = first_[node]; k < first_[node + 1]; ++k) {
      const Vec3& q = network_.nodes[other_end(edges_[k], node)].position;
      const double ahead = way.dot((q - p).stableNormalized());
      if (ahead <= most) continue;
      most = ahead;
      best = edges_[k];
    }
    return best;
  }
  std::int32_t other_end(std::int32_t edge, std::int32_t node) const {
    const CrackEdge& e = network_.edges[edge];
    return e.a == node ? e.b : e.a;
  }

 private:
  const CrackNetwork& network_;
  std::vector<std::int32_t> first_, edges_;
};

}  // namespace

std::vector<CrackSides> crack_sides_of(const TriangleMesh& mesh, const std::vector<Vec3>& field,
                                       const CrackNetwork& network) {
  const Vec3 zero = Vec3::Zero();
  std::vector<CrackSides> result(network.edges.size(),
                                 {{{{zero, zero}, {zero, zero}}}, {{-1, -1}}});
  std::vector<std::int32_t> node_of(mesh.vertex_count(), -1);  // by root
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    node_of[mesh.root(network.nodes[n].vertex)] = static_cast<std::int32_t>(n);
  }
  const NodeEdges edges(network);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.crack_of(h) < 0) continue;
    const std::int32_t v = mesh.from(h), w = mesh.to(h);
    const Vec3 &p = mesh.position(v), &q = mesh.position(w);
    const auto value = [&](std::int32_t node) -> Vec3 {
      const double t = nearest_on_segment(network.nodes[node].position, p, q);
      return (1 - t) * field[v] + t * field[w];
    };
    std::int32_t node = node_of[mesh.root(v)];
    const std::int32_t last = node_of[mesh.root(w)];
    // The nodes inside the halfedge, which the other side was split at, lie on its line.
    for (std::size_t step = 0; node >= 0 && node != last && step < network.edges.size(); ++step) {
      const std::int32_t e = edges.towards(node, q);
      if (e < 0) break;
      const std::int32_t next = edges.other_end(e, node);
      const bool forward = network.edges[e].a == node;
      CrackSides& sides = result[e];
      const std::size_t side = forward ? 0 : 1;
      sides.value[side] = {value(network.edges[e].a), value(network.edges[e].b)};
      sides.face[side] = TriangleMesh::face_of(h);
      node = next;
    }
  }
  return result;
}

}  // namespace craze
