#include "craze/mesh/sorted_halfedges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace craze {

VertexPair vertices_of(const std::vector<Triangle>& triangles, std::int32_t halfedge) {
  const Triangle& t = triangles[halfedge / 3];
  const std::int32_t a = t[halfedge % 3], b = t[(halfedge + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

std::vector<std::int32_t> sorted_halfedges(const std::vector<Triangle>& triangles,
                                           std::size_t vertices) {
  struct Entry {
    std::int32_t high, halfedge;
    bool operator<(const Entry& o) const {
      return std::tie(high, halfedge) < std::tie(o.high, o.halfedge);
    }
  };
  // A row for each lower vertex, then each row by itself.
  const auto count = static_cast<std::int32_t>(3 * triangles.size());
  std::vector<std::int32_t> begin(vertices + 1, 0);
  for (std::int32_t h = 0; h < count; ++h) ++begin[vertices_of(triangles, h).low + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Entry> entries(count);
  std::vector<std::int32_t> end(begin.begin(), begin.end() - 1);
  for (std::int32_t h = 0; h < count; ++h) {
    const VertexPair edge = vertices_of(triangles, h);
    entries[end[edge.low]++] = {edge.high, h};
  }
  std::vector<std::int32_t> sorted;
  sorted.reserve(count);
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(entries.begin() + begin[v], entries.begin() + begin[v + 1]);
    for (std::int32_t i = begin[v]; i < begin[v + 1]; ++i) sorted.push_back(entries[i].halfedge);
  }
  return sorted;
}

}  // namespace craze
