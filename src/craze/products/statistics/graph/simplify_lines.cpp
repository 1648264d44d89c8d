#include "craze/products/statistics/graph/simplify_lines.h"

#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "craze/base/segment_distance.h"

namespace craze {

namespace {

/// Which points of a line stay, in order, its ends among them.
std::vector<std::size_t> kept_points(const std::vector<Vec3>& line, double tolerance) {
  std::vector<char> kept(line.size(), 0);
  kept.front() = kept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = point_segment_distance(line[i], line[first], line[last]);
      if (distance > farthest) {
        farthest = distance;
        split = i;
      }
    }
    if (split == first) continue;
    kept[split] = 1;
    open.emplace_back(first, split);
    open.emplace_back(split, last);
  }
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) points.push_back(i);
  }
  return points;
}

/// Times: those not known, NaN, are alike.
bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// Whether the line may run through a point between these two edges.
bool are_one_line(const GraphInputEdge& e, const GraphInputEdge& f, bool same_way) {
  const std::int32_t left = same_way ? f.left_piece : f.right_piece;
  const std::int32_t right = same_way ? f.right_piece : f.left_piece;
  return !e.border && !f.border && same(e.time, f.time) && e.event == f.event &&
         e.left_piece == left && e.right_piece == right;
}

}  // namespace

void simplify_lines(CrackGraphInput& graph, double tolerance) {
  if (!(tolerance > 0)) return;
  const auto points = graph.points.size();
  std::vector<std::array<std::int32_t, 2>> at(points, {-1, -1});  // first edges
  std::vector<int> degree(points, 0);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    for (const std::int32_t p : {graph.edges[e].a, graph.edges[e].b}) {
      if (degree[p] < 2) at[p][degree[p]] = static_cast<std::int32_t>(e);
      ++degree[p];
    }
  }
  const auto runs_through = [&](std::int32_t p) {
    if (degree[p] != 2 || at[p][0] == at[p][1]) return false;
    const GraphInputEdge &e = graph.edges[at[p][0]], &f = graph.edges[at[p][1]];
    return are_one_line(e, f, (e.b == p) == (f.a == p));
  };

  std::vector<GraphInputEdge> edges;
  std::set<std::pair<std::int32_t, std::int32_t>> straight;  // lines that became one edge
  std::vector<char> done(graph.edges.size(), 0);
  const auto follow = [&](std::int32_t start, std::int32_t first) {
    std::vector<std::int32_t> chain{start};
    std::int32_t e = first, p = start;
    do {
      done[e] = 1;
      p = graph.edges[e].a == p ? graph.edges[e].b : graph.edges[e].a;
      chain.push_back(p);
      if (!runs_through(p)) break;
      e = at[p][0] == e ? at[p][1] : at[p][0];
    } while (p != start);
    std::vector<Vec3> line;
    line.reserve(chain.size());
    for (const std::int32_t i : chain) line.push_back(graph.points[i]);
    GraphInputEdge piece = graph.edges[first];
    if (piece.a != start) std::swap(piece.left_piece, piece.right_piece);
    std::vector<std::size_t> kept = kept_points(line, tolerance);
    // A ring stays one, and of two lines between the same points one keeps its bends.
    const bool is_straight = kept.size() == 2;
    if ((chain.front() == chain.back() && kept.size() < 4) ||
        (is_straight && !straight.insert(std::minmax(chain.front(), chain.back())).second)) {
      kept.resize(line.size());
      std::iota(kept.begin(), kept.end(), std::size_t{0});
    }
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
      piece.a = chain[kept[i]];
      piece.b = chain[kept[i + 1]];
      edges.push_back(piece);
    }
  };
  // Lines from one end to the other, then rings that have none.
  for (const bool rings : {false, true}) {
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      for (const std::int32_t p : {graph.edges[e].a, graph.edges[e].b}) {
        if (!done[e] && (rings || !runs_through(p))) follow(p, static_cast<std::int32_t>(e));
      }
    }
  }
  graph.edges = std::move(edges);
}

}  // namespace craze
