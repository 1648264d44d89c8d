#include "craze/products/statistics/graph/pixel_diagonals.h"

#include <algorithm>
#include <cmath>

namespace craze {

namespace {

constexpr double tolerance = 1e-6;  // relative

/// The other ends of each point's shortest edges, ascending.
using Steps = std::vector<std::vector<std::int32_t>>;

bool share_a_neighbour(const Steps& steps, std::int32_t a, std::int32_t b) {
  const auto &of_a = steps[a], &of_b = steps[b];
  for (auto i = of_a.begin(), j = of_b.begin(); i != of_a.end() && j != of_b.end();) {
    if (*i == *j) return true;
    if (*i < *j) {
      ++i;
    } else {
      ++j;
    }
  }
  return false;
}

}  // namespace

void drop_pixel_diagonals(CrackGraphInput& graph) {
  const auto length = [&](const GraphInputEdge& e) {
    return (graph.points[e.a] - graph.points[e.b]).norm();
  };
  double pixel = std::numeric_limits<double>::infinity();
  for (const GraphInputEdge& e : graph.edges) pixel = std::min(pixel, length(e));
  Steps steps(graph.points.size());
  for (const GraphInputEdge& e : graph.edges) {
    if (length(e) > (1 + tolerance) * pixel) continue;
    steps[e.a].push_back(e.b);
    steps[e.b].push_back(e.a);
  }
  for (auto& ends : steps) std::sort(ends.begin(), ends.end());
  const double diagonal = std::sqrt(2.0) * pixel;
  std::erase_if(graph.edges, [&](const GraphInputEdge& e) {
    const bool is_diagonal = std::abs(length(e) - diagonal) <= tolerance * diagonal;
    return is_diagonal && !e.border && std::isnan(e.time) && share_a_neighbour(steps, e.a, e.b);
  });
}

}  // namespace craze
