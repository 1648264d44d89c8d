#include "craze/products/growth/drag.h"

#include <algorithm>
#include <numeric>

namespace craze {

namespace {

/// An edge may change by this part of its length.
constexpr double give = 0.5;
/// Drags reach a few triangles far.
constexpr int sweeps = 40;
/// Drags below this part of an edge are no longer passed on.
constexpr double small = 1e-3;

}  // namespace

Drag::Drag(const TriangleMesh& mesh, const CrackSites& sites) : node_of_(sites.site_of) {
  auto nodes = static_cast<std::int32_t>(sites.vertex.size());
  for (std::int32_t& node : node_of_) {
    if (node < 0) node = nodes++;
  }
  first_vertex_.assign(nodes + 1, 0);
  for (const std::int32_t node : node_of_) ++first_vertex_[node + 1];
  std::partial_sum(first_vertex_.begin(), first_vertex_.end(), first_vertex_.begin());
  vertices_.resize(node_of_.size());
  std::vector<std::int32_t> next(first_vertex_.begin(), first_vertex_.end() - 1);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) vertices_[next[node_of_[v]]++] = v;

  first_neighbour_.push_back(0);
  for (std::int32_t node = 0; node < nodes; ++node) {
    for (std::int32_t i = first_vertex_[node]; i < first_vertex_[node + 1]; ++i) {
      const std::int32_t v = vertices_[i];
      const auto add = [&](std::int32_t w) {
        neighbours_.push_back({w, give * (mesh.position(w) - mesh.position(v)).norm()});
      };
      mesh.for_each_outgoing(v, [&](std::int32_t h) {
        add(mesh.to(h));
        if (mesh.is_open(TriangleMesh::prev(h))) add(mesh.from(TriangleMesh::prev(h)));
      });
    }
    first_neighbour_.push_back(static_cast<std::int32_t>(neighbours_.size()));
  }
}

void Drag::along(const std::vector<double>& slack, std::vector<Vec3>& move) const {
  const std::size_t nodes = first_neighbour_.size() - 1;
  std::vector<Vec3> dragged(nodes, Vec3::Zero());
  std::vector<Vec3> alone(move);
  std::vector<std::uint8_t> look(nodes, 0), look_next(nodes, 0);
  const auto wake_around = [&](std::size_t node, std::vector<std::uint8_t>& marks) {
    for (std::int32_t i = first_neighbour_[node]; i < first_neighbour_[node + 1]; ++i) {
      marks[node_of_[neighbours_[i].vertex]] = 1;
    }
  };
  for (std::size_t v = 0; v < move.size(); ++v) {
    if (!move[v].isZero(0)) wake_around(node_of_[v], look);
  }
  bool again = true;
  for (int sweep = 0; sweep < sweeps && again; ++sweep) {
    again = false;
    for (std::size_t node = 0; node < nodes; ++node) {
      const std::int32_t v = vertices_[first_vertex_[node]];
      if (!look[node] || !(slack[v] > 0)) continue;
      const bool waits = first_vertex_[node + 1] - first_vertex_[node] > 1;
      const Vec3 here = (waits ? Vec3(Vec3::Zero()) : alone[v]) + dragged[node];
      Vec3 pull = Vec3::Zero();
      double weight = 0, least = 0;
      for (std::int32_t i = first_neighbour_[node]; i < first_neighbour_[node + 1]; ++i) {
        const Vec3 apart = move[neighbours_[i].vertex] - here;
        const double distance = apart.norm(), excess = distance - neighbours_[i].slackness;
        if (!(excess > 0)) continue;
        pull += excess * excess / distance * apart;
        weight += excess;
        least = std::max(least, small * neighbours_[i].slackness);
      }
      if (!(weight > 0)) continue;
      dragged[node] += pull / weight;
      for (std::int32_t i = first_vertex_[node]; i < first_vertex_[node + 1]; ++i) {
        move[vertices_[i]] = alone[vertices_[i]] + slack[v] * dragged[node];
      }
      if (pull.norm() <= weight * least) continue;
      wake_around(node, look_next);
      look_next[node] = 1;
      again = true;
    }
    look.swap(look_next);
    std::fill(look_next.begin(), look_next.end(), 0);
  }
}

}  // namespace craze
