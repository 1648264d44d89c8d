#include "craze/products/opening/bend_refinement.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "craze/base/elementary.h"

namespace craze {

namespace {

/// Splits the longest edges first, so that triangles stay as round as they were.
class Bender {
 public:
  Bender(TriangleMesh mesh, std::vector<double> crack_distance, double length)
      : mesh_(std::move(mesh)),
        distance_(std::move(crack_distance)),
        longest_(std::sqrt(8 * bend_tolerance) * length),
        reach_(bend_reach(length)) {}

  TriangleMesh run() {
    for (std::int32_t h = 0; h < 3 * mesh_.face_count(); ++h) offer(h);
    while (!edges_.empty()) {
      const auto [length, h] = edges_.top();
      edges_.pop();
      // By now h may be another edge.
      if (length == edge_length(h) && is_too_long(h) && is_longest(h)) split(h);
    }
    return std::move(mesh_);
  }

 private:
  double edge_length(std::int32_t h) const {
    return (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).norm();
  }

  /// Of the faces at an edge. What is not the longest waits until that is split, for ever if it is
  /// not to be split: else edges beside it would be split without end and get no shorter.
  bool is_longest(std::int32_t h) const {
    const double length = edge_length(h);
    for (const std::int32_t g : {h, mesh_.opposite(h)}) {
      if (g >= 0 && std::max(edge_length(TriangleMesh::next(g)),
                             edge_length(TriangleMesh::prev(g))) > length) {
        return false;
      }
    }
    return true;
  }

  bool is_too_long(std::int32_t h) const {
    return mesh_.crack_of(h) < 0 && edge_length(h) > longest_ &&
           std::min(distance_[mesh_.from(h)], distance_[mesh_.to(h)]) <= reach_;
  }

  void offer(std::int32_t h) {
    const bool stands_for_edge = mesh_.opposite(h) < h;
    if (stands_for_edge && is_too_long(h)) edges_.emplace(edge_length(h), h);
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

double bend_reach(double length) {
  return -elementary::log(bend_tolerance) * length;
}

std::shared_ptr<const TriangleMesh> refined_to_bend(const TriangleMesh& mesh,
                                                    std::vector<double> crack_distance,
                                                    double length) {
  const std::int32_t faces = mesh.face_count();
  TriangleMesh refined = Bender(mesh, std::move(crack_distance), length).run();
  if (refined.face_count() == faces) return nullptr;
  return std::make_shared<const TriangleMesh>(std::move(refined));
}

}  // namespace craze
