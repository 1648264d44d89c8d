#include "craze/io/gltf/scene/cut_vertices.h"

#include <algorithm>

namespace craze {

std::uint32_t VertexBlend::nearest() const {
  int most = 0;
  for (int i = 1; i < size(); ++i) {
    if (weights[i] > weights[most]) most = i;
  }
  return from[most];
}

VertexBlend make_blend(const std::array<std::uint32_t, 3>& triangle, const Vec3& weights) {
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return triangle[a] < triangle[b]; });
  VertexBlend blend;
  int n = 0;
  for (const int i : order) {
    if (weights[i] == 0) continue;
    // A triangle may name a vertex twice.
    if (n > 0 && blend.from[n - 1] == triangle[i]) {
      blend.weights[n - 1] += weights[i];
      continue;
    }
    blend.from[n] = triangle[i];
    blend.weights[n++] = weights[i];
  }
  if (n == 1) blend.weights[0] = 1;
  return blend;
}

std::uint32_t CutVertices::number(const VertexBlend& blend, std::int32_t of) {
  if (blend.is_copy()) {
    std::int32_t& owner = owner_[blend.from[0]];
    if (owner < 0) owner = of;
    if (owner == of) return blend.from[0];
  }
  const auto [found, is_new] =
      numbers_.try_emplace({of, blend.from}, static_cast<std::uint32_t>(count()));
  if (is_new) added_.push_back({blend, of});
  return found->second;
}

}  // namespace craze
