#include "craze/io/gltf/scene/part_placement.h"

#include <Eigen/QR>
#include <cmath>

namespace craze {

namespace {

/// The shortest solution of linear x = v.
Vec3 solve(const Eigen::Matrix4d& matrix, const Vec3& v) {
  const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
  return linear.completeOrthogonalDecomposition().solve(v);
}

}  // namespace

PartPlacement::PartPlacement(const GltfPart& part, const std::vector<Eigen::Matrix4d>& joints,
                             const std::vector<JointSet>& sets)
    : transform_(part.transform), joints_(joints), sets_(sets) {}

/// As the reader places it: the mean of the joints' matrices by weight, the first joint's where
/// there is no weight.
Eigen::Matrix4d PartPlacement::matrix(std::size_t vertex) const {
  if (!is_skinned()) return transform_;
  const auto joint = [&](const JointSet& set, std::size_t k) -> const Eigen::Matrix4d& {
    const auto j = static_cast<std::size_t>(set.joints.value(vertex, k));
    return joints_[j < joints_.size() ? j : 0];
  };
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  double total = 0;
  for (const JointSet& set : sets_) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = set.weights.value(vertex, k);
      if (weight == 0) continue;
      sum += weight * joint(set, k);
      total += weight;
    }
  }
  return total > 0 ? Eigen::Matrix4d(sum / total) : joint(sets_[0], 0);
}

Vec3 PartPlacement::to_local(std::size_t vertex, const Vec3& point) const {
  const Eigen::Matrix4d m = matrix(vertex);
  return solve(m, point - m.topRightCorner<3, 1>());
}

Vec3 PartPlacement::shift_to_local(std::size_t vertex, const Vec3& shift) const {
  return solve(matrix(vertex), shift);
}

Vec3 PartPlacement::normal_to_local(std::size_t vertex, const Vec3& normal) const {
  const Vec3 local = matrix(vertex).topLeftCorner<3, 3>().transpose() * normal;
  return local.norm() > 0 ? Vec3(local.normalized()) : normal;
}

}  // namespace craze
