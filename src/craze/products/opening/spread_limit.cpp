#include "craze/products/opening/spread_limit.h"

#include <functional>
#include <queue>
#include <utility>

namespace craze {

void spread_limit(const TriangleMesh& mesh, const CrackSites& sites,
                  const std::vector<std::vector<std::int32_t>>& on_site, double most, double growth,
                  double length, std::vector<double>& limit) {
  std::vector<std::int32_t> from;
  for (std::size_t v = 0; v < limit.size(); ++v) {
    if (limit[v] < most) from.push_back(static_cast<std::int32_t>(v));
  }
  spread_limit_from(mesh, sites, on_site, from, growth, length, limit);
}

void spread_limit_from(const TriangleMesh& mesh, const CrackSites& sites,
                       const std::vector<std::vector<std::int32_t>>& on_site,
                       const std::vector<std::int32_t>& lowered, double growth, double length,
                       std::vector<double>& limit) {
  using Entry = std::pair<double, std::int32_t>;  // limit, vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::int32_t v : lowered) queue.emplace(limit[v], v);
  const auto lower = [&](std::int32_t v, double to) {
    if (limit[v] <= to) return;
    limit[v] = to;
    queue.emplace(to, v);
  };
  while (!queue.empty()) {
    const double least = queue.top().first;
    const std::int32_t v = queue.top().second;
    queue.pop();
    if (least > limit[v]) continue;
    if (const std::int32_t site = sites.site_of[v]; site >= 0) {
      for (const std::int32_t u : on_site[site]) lower(u, least);
    }
    mesh.for_each_outgoing(v, [&](std::int32_t h) {
      for (const std::int32_t u : {mesh.to(h), mesh.from(TriangleMesh::prev(h))}) {
        lower(u, least + growth * (mesh.position(u) - mesh.position(v)).norm() / length);
      }
    });
  }
}

}  // namespace craze
