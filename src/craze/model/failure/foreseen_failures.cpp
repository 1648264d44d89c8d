#include "craze/model/failure/foreseen_failures.h"

#include <algorithm>
#include <cmath>

namespace craze {

void ForeseenFailures::begin(std::vector<std::int32_t> nodes) {
  std::sort(nodes.begin(), nodes.end());
  failures_.assign(nodes.size(), {});
  for (std::size_t i = 0; i < nodes.size(); ++i) failures_[i].node = nodes[i];
}

const ForeseenFailure* ForeseenFailures::find(std::int32_t v) const {
  const auto found =
      std::lower_bound(failures_.begin(), failures_.end(), v,
                       [](const ForeseenFailure& f, std::int32_t node) { return f.node < node; });
  return found != failures_.end() && found->node == v && found->holds ? &*found : nullptr;
}

void ForeseenFailures::opened(const TriangleMesh& mesh, std::int32_t v,
                              const std::vector<std::int32_t>& changed, double influence) {
  if (failures_.empty()) return;
  double squared = 0;  // of the distance to the farthest of them
  for (const std::int32_t n : changed) squared = std::max(squared, mesh.way(v, n).squaredNorm());
  const double near = std::sqrt(squared) + influence;
  for (ForeseenFailure& f : failures_) {
    f.holds = f.holds && mesh.way(v, f.node).squaredNorm() > near * near;
  }
}

}  // namespace craze
