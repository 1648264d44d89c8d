#include "craze/engine/asset/asset_topology.h"

#include <algorithm>
#include <utility>

#include "craze/mesh/repair/weld.h"

namespace craze {

AssetTopology::AssetTopology(const std::vector<Vec3>& positions,
                             const std::vector<Triangle>& triangles)
    : AssetTopology(triangles, weld(positions, 0)) {}

AssetTopology::AssetTopology(const std::vector<Triangle>& triangles,
                             std::vector<std::int32_t> places)
    : triangles_(triangles), places_(std::move(places)) {
  collect_corners();
  collect_edges();
}

void AssetTopology::collect_corners() {
  const std::int32_t halfedges = 3 * face_count();
  first_leaving_.assign(places_.size() + 1, 0);
  for (std::int32_t h = 0; h < halfedges; ++h) ++first_leaving_[from(h) + 1];
  for (std::size_t v = 0; v < places_.size(); ++v) first_leaving_[v + 1] += first_leaving_[v];
  leaving_.resize(halfedges);
  std::vector<std::int32_t> next(first_leaving_.begin(), first_leaving_.end() - 1);
  for (std::int32_t h = 0; h < halfedges; ++h) leaving_[next[from(h)]++] = h;
}

// Each edge is met at its lower end: halfedges that leave it upward, and those that come down to it
// along the corner before.
void AssetTopology::collect_edges() {
  edge_.assign(3 * triangles_.size(), -1);
  first_side_.assign(1, 0);
  sides_.reserve(3 * triangles_.size());
  std::vector<std::pair<std::int32_t, std::int32_t>> upward;  // (upper end, halfedge)
  for (std::int32_t v = 0; v < vertex_count(); ++v) {
    upward.clear();
    for (const std::int32_t h : leaving(v)) {
      const std::int32_t before = h % 3 == 0 ? h + 2 : h - 1;
      if (to(h) > v) upward.emplace_back(to(h), h);
      if (from(before) > v) upward.emplace_back(from(before), before);
    }
    std::sort(upward.begin(), upward.end());
    for (std::size_t i = 0; i < upward.size(); ++i) {
      if (i > 0 && upward[i].first != upward[i - 1].first) {
        first_side_.push_back(static_cast<std::int32_t>(sides_.size()));
      }
      edge_[upward[i].second] = edge_count();
      sides_.push_back(upward[i].second);
    }
    if (!upward.empty()) first_side_.push_back(static_cast<std::int32_t>(sides_.size()));
  }
}

}  // namespace craze
