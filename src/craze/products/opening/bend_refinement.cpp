#include "craze/products/opening/bend_refinement.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "craze/base/elementary.h"

namespace craze {

namespace {

/// Splits the longest edges first, so that triangles stay as round as they were. The two sides of a
/// crack are as long as each other, so they are split alike.
class Bender {
 public:
  Bender(TriangleMesh mesh, std::vector<double> crack_distance, double length)
      : mesh_(std::move(mesh)),
        distance_(std::move(crack_distance)),
        longest_(std::sqrt(8 * bend_tolerance) * length),
        reach_(-elementary::log(bend_tolerance) * length) {}

  TriangleMesh run() {
    for (std::int32_t h = 0; h < 3 * mesh_.face_count(); ++h) offer(h);
    while (!edges_.empty()) {
      const auto [length, h] = edges_.top();
      edges_.pop();
      if (length == edge_length(h)) split(h);
    }
    return std::move(mesh_);
  }

 private:
  double edge_length(std::int32_t h) const {
    return (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).norm();
  }

  void offer(std::int32_t h) {
    if (mesh_.opposite(h) > h) return;  // each edge once
    const double length = edge_length(h);
    if (length <= longest_) return;
    if (std::min(distance_[mesh_.from(h)], distance_[mesh_.to(h)]) > reach_) return;
    edges_.emplace(length, h);
  }

  void split(std::int32_t h) {
    const double middle = 0.5 * (distance_[mesh_.from(h)] + distance_[mesh_.to(h)]);
    const TriangleMesh::Split made = mesh_.split_edge(h, 0.5);
    distance_.push_back(middle);
    mesh_.for_each_outgoing(made.vertex, [&](std::int32_t out) {
      for (const std::int32_t side : {out, TriangleMesh::next(out), TriangleMesh::prev(out)}) {
        offer(mesh_.is_open(side) ? side : std::max(side, mesh_.opposite(side)));
      }
    });
  }

  TriangleMesh mesh_;
  std::vector<double> distance_;  // #V
  double longest_, reach_;
  std::priority_queue<std::pair<double, std::int32_t>> edges_;
};

}  // namespace

std::shared_ptr<const TriangleMesh> refined_to_bend(const TriangleMesh& mesh,
                                                    std::vector<double> crack_distance,
                                                    double length) {
  const std::int32_t faces = mesh.face_count();
  TriangleMesh refined = Bender(mesh, std::move(crack_distance), length).run();
  if (refined.face_count() == faces) return nullptr;
  return std::make_shared<const TriangleMesh>(std::move(refined));
}

}  // namespace craze
