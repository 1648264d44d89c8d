#include "craze/io/lines/write_lines.h"

namespace craze {

namespace {

/// The edges at each point: those of p are edges[begin[p]] … edges[begin[p + 1]].
struct PointEdges {
  explicit PointEdges(const LineSet& lines)
      : begin(lines.points.size() + 1, 0), edges(2 * lines.edges.size()) {
    for (const auto& e : lines.edges) {
      for (const std::int32_t p : e) ++begin[p + 1];
    }
    for (std::size_t p = 1; p < begin.size(); ++p) begin[p] += begin[p - 1];
    std::vector<std::size_t> at(begin.begin(), begin.end() - 1);
    for (std::size_t e = 0; e < lines.edges.size(); ++e) {
      for (const std::int32_t p : lines.edges[e]) edges[at[p]++] = static_cast<std::int32_t>(e);
    }
  }
  std::size_t degree(std::int32_t p) const { return begin[p + 1] - begin[p]; }

  std::vector<std::size_t> begin;
  std::vector<std::int32_t> edges;
};

}  // namespace

std::vector<std::vector<std::int32_t>> join_edges(const LineSet& lines) {
  const PointEdges around(lines);
  std::vector<bool> used(lines.edges.size(), false);
  std::vector<std::vector<std::int32_t>> chains;

  const auto follow = [&](std::int32_t point, std::int32_t edge) {
    std::vector<std::int32_t>& chain = chains.emplace_back();
    chain.push_back(point);
    while (edge >= 0) {
      used[edge] = true;
      const auto& ends = lines.edges[edge];
      point = ends[0] == point ? ends[1] : ends[0];
      chain.push_back(point);
      edge = -1;
      if (around.degree(point) != 2) break;
      for (std::size_t i = around.begin[point]; i < around.begin[point + 1]; ++i) {
        if (!used[around.edges[i]]) edge = around.edges[i];
      }
    }
  };
  for (const bool loops : {false, true}) {
    for (std::int32_t p = 0; p < static_cast<std::int32_t>(lines.points.size()); ++p) {
      if (!loops && around.degree(p) == 2) continue;
      for (std::size_t i = around.begin[p]; i < around.begin[p + 1]; ++i) {
        if (!used[around.edges[i]]) follow(p, around.edges[i]);
      }
    }
  }
  return chains;
}

}  // namespace craze
