// The graph of a crack pattern, embedded in a surface: junctions, the lines between them, and the
// cyclic order of the lines around each junction.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "craze/products/statistics/graph/graph_input.h"

namespace craze {

/// One end of an edge: dart 2e leaves the first point of edge e, dart 2e+1 its last.
using Dart = std::int32_t;

/// A combinatorial map. Chains of degree-2 points are single edges. Removed edges and nodes keep
/// their index and have no points and no darts.
class CrackGraph {
 public:
  struct Segment {
    double time = std::numeric_limits<double>::quiet_NaN();
    std::int32_t event = -1;
    std::int32_t left_piece = -1, right_piece = -1;
  };
  struct Node {
    Vec3 position, normal;
    bool border = false;      ///< on a border edge
    std::vector<Dart> darts;  ///< leaving, counter-clockwise seen from outside
  };
  struct Edge {
    std::vector<Vec3> points, normals;
    std::vector<Segment> segments;  ///< one fewer than points
    double length = 0;
    bool border = false;
  };

  explicit CrackGraph(const CrackGraphInput& input);

  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Edge>& edges() const { return edges_; }
  bool is_alive(std::int32_t e) const { return !edges_[e].points.empty(); }
  static Dart twin(Dart d) { return d ^ 1; }
  std::int32_t origin(Dart d) const { return origin_[d]; }
  std::int32_t target(Dart d) const { return origin_[d ^ 1]; }
  std::size_t degree(std::int32_t node) const { return nodes_[node].darts.size(); }
  /// A free tip: the end of one crack, not on the border.
  bool is_tip(std::int32_t node) const { return degree(node) == 1 && !nodes_[node].border; }
  /// Edge d/2 as seen when leaving along d.
  Edge directed(Dart d) const;

  /// Removes dead ends shorter than `length`, shortest first.
  void prune_spurs(double length);
  /// Shrinks crack edges shorter than `length` to a point, shortest first.
  void contract_edges(double length);
  /// Removes every crack edge that has the same face on both sides: dead ends, trees, bridges.
  void remove_dead_ends();

  /// Each loop of darts with a face on its left, by the order around the nodes.
  std::vector<std::vector<Dart>> trace_faces() const;

 private:
  void remove_edge(std::int32_t e);
  /// Joins the two lines of a degree-2 node, unless they are one line or of different kinds.
  void join_at(std::int32_t node);
  void detach(Dart d);

  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
  std::vector<std::int32_t> origin_;  // node of each dart
};

}  // namespace craze
