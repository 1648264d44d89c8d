#include "craze/model/failure/foreseen_failures.h"

#include <algorithm>
#include <cmath>

namespace craze {

void ForeseenFailures::begin(const TriangleMesh& mesh, std::vector<std::int32_t> nodes) {
  std::sort(nodes.begin(), nodes.end());
  failures_.assign(nodes.size(), {});
  places_.clear();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    failures_[i].node = nodes[i];
    places_.push_back({mesh.position(nodes[i]).x(), static_cast<std::int32_t>(i)});
  }
  std::sort(places_.begin(), places_.end(),
            [](const Place& a, const Place& b) { return a.x < b.x; });
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
  // Where the mesh repeats, what is near may lie at the other end.
  const bool repeats = mesh.period().is_given();
  const double x = mesh.position(v).x();
  auto place = places_.begin();
  if (!repeats) {
    place = std::lower_bound(places_.begin(), places_.end(), x - near,
                             [](const Place& p, double least) { return p.x < least; });
  }
  for (; place != places_.end() && (repeats || place->x <= x + near); ++place) {
    ForeseenFailure& f = failures_[place->failure];
    f.holds = f.holds && mesh.way(v, f.node).squaredNorm() > near * near;
  }
}

}  // namespace craze
