#include "craze/model/crack_network.h"

#include <algorithm>

namespace craze {

namespace {

/// One side of a crack edge: a halfedge of the cut mesh that carries its label.
struct Side {
  std::int32_t label;
  std::int32_t halfedge;
};

/// Mean displacement of the halfedges of one side, weighted by length.
struct MeanDisplacement {
  Vec3 sum = Vec3::Zero();
  double length = 0;
  Vec3 mean() const { return length > 0 ? Vec3(sum / length) : Vec3::Zero(); }
};

/// How far along a segment a side reaches.
struct Reach {
  double begin, end;
  std::int32_t halfedge;
};

/// The shortest of those that hold the piece from begin to end: one side of a crack may be split
/// where the other is not.
std::int32_t shortest_side(const std::vector<Reach>& reaches, double begin, double end) {
  const Reach* best = nullptr;
  for (const Reach& r : reaches) {
    if (r.begin > begin || r.end < end) continue;
    if (!best || r.end - r.begin < best->end - best->begin) best = &r;
  }
  return best ? best->halfedge : -1;
}

}  // namespace

CrackNetwork crack_network(const Simulation& simulation) {
  const TriangleMesh& mesh = simulation.mesh();
  CrackNetwork network;
  network.period = mesh.period();
  const std::int32_t halfedges = 3 * mesh.face_count();
  std::vector<Side> sides;
  for (std::int32_t h = 0; h < halfedges; ++h) {
    if (mesh.crack_of(h) >= 0) sides.push_back({mesh.crack_of(h), h});
  }
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& a, const Side& b) { return a.label < b.label; });

  std::vector<std::int32_t> node_of_root(mesh.vertex_count(), -1);
  const auto node = [&](std::int32_t root) {
    if (node_of_root[root] < 0) {
      node_of_root[root] = static_cast<std::int32_t>(network.nodes.size());
      network.nodes.push_back({mesh.position(root), Vec3::Zero(), -1, JunctionKind::bend, root});
    }
    return node_of_root[root];
  };

  std::vector<std::pair<double, std::int32_t>> along;  // (position on the segment, root)
  std::vector<Reach> reaches;
  for (std::size_t i = 0; i < sides.size();) {
    const OpenedSegment& segment = simulation.opened()[sides[i].label];
    const std::int32_t a = segment.geometry.from_root, b = segment.geometry.to_root;
    const Vec3 direction = mesh.way(a, b);
    along.clear();
    reaches.clear();
    MeanDisplacement left, right;
    std::size_t j = i;
    for (; j < sides.size() && sides[j].label == sides[i].label; ++j) {
      const std::int32_t from = mesh.from(sides[j].halfedge), to = mesh.to(sides[j].halfedge);
      const Vec3 edge = mesh.way(from, to);
      MeanDisplacement& side = edge.dot(direction) > 0 ? left : right;
      side.sum += 0.5 * edge.norm() * (simulation.displacement(from) + simulation.displacement(to));
      side.length += edge.norm();
      const double begin = mesh.way(a, from).dot(direction);
      const double end = mesh.way(a, to).dot(direction);
      along.emplace_back(begin, mesh.root(from));
      along.emplace_back(end, mesh.root(to));
      reaches.push_back({std::min(begin, end), std::max(begin, end), sides[j].halfedge});
    }
    i = j;
    std::sort(along.begin(), along.end());
    along.erase(std::unique(along.begin(), along.end()), along.end());
    const double width = (left.mean() - right.mean()).norm();
    for (std::size_t k = 0; k + 1 < along.size(); ++k) {
      CrackEdge edge;
      edge.a = node(along[k].second);
      edge.b = node(along[k + 1].second);
      edge.time = segment.time;
      edge.width = width;
      edge.event = segment.event;
      edge.face = segment.geometry.source_face;
      edge.side = shortest_side(reaches, along[k].first, along[k + 1].first);
      network.edges.push_back(edge);
    }
  }

  describe_nodes(mesh, network);
  return network;
}

double total_length(const CrackNetwork& network) {
  double length = 0;
  for (const CrackEdge& e : network.edges) length += network.length(e);
  return length;
}

void describe_nodes(const TriangleMesh& mesh, CrackNetwork& network) {
  std::vector<std::int32_t> node_of_root(mesh.vertex_count(), -1);
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    node_of_root[network.nodes[n].vertex] = static_cast<std::int32_t>(n);
  }
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangle(f);
    const Vec3 normal = mesh.way(t[0], t[1]).cross(mesh.way(t[0], t[2]));
    for (const std::int32_t v : t) {
      const std::int32_t n = node_of_root[mesh.root(v)];
      if (n < 0) continue;
      network.nodes[n].normal += normal;
      network.nodes[n].face = mesh.source_face(f);
    }
  }
  std::vector<std::int32_t> degree(network.nodes.size(), 0);
  for (const CrackEdge& edge : network.edges) {
    ++degree[edge.a];
    ++degree[edge.b];
  }
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    CrackNode& node = network.nodes[n];
    node.normal.normalize();
    node.kind = degree[n] == 1   ? JunctionKind::end
                : degree[n] == 2 ? JunctionKind::bend
                                 : JunctionKind::junction;
  }
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) != TriangleMesh::border) continue;
    for (const std::int32_t v : {mesh.from(h), mesh.to(h)}) {
      const std::int32_t n = node_of_root[mesh.root(v)];
      if (n >= 0) network.nodes[n].kind = JunctionKind::border;
    }
  }
}

std::vector<HealedPiece> healed_pieces(const CrackNetwork& network) {
  std::vector<HealedPiece> pieces;
  pieces.reserve(network.edges.size());
  for (const CrackEdge& e : network.edges) {
    const CrackNode &a = network.nodes[e.a], &b = network.nodes[e.b];
    pieces.push_back(
        {a.position, network.period.nearest(b.position, a.position), a.normal + b.normal});
  }
  return pieces;
}

}  // namespace craze
