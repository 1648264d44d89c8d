// Where the nodes of a glTF file are.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "craze/io/gltf/gltf_json.h"

namespace craze {

/// The tree of nodes, seen from below: each node's place among the scene's axes, whatever scene
/// shows it. Places are found when they are asked for.
class GltfNodes {
 public:
  /// Both must outlive this. Throws Error(input) for a child that is no node.
  GltfNodes(const Json& root, const std::string& name);

  std::size_t count() const { return parents_.size(); }
  bool has_parent(std::size_t node) const { return parents_[node] >= 0; }
  /// Throws Error(input) where the node is its own ancestor, or its transform is not finite.
  const Eigen::Matrix4d& world(std::size_t node);

 private:
  const Json& root_;
  GltfJson json_;
  std::vector<std::ptrdiff_t> parents_;  ///< −1: none
  std::vector<Eigen::Matrix4d> worlds_;
  std::vector<bool> known_;
};

/// A transform made of its three parts; the rotation is a quaternion x y z w of any length but 0.
Eigen::Matrix4d compose_transform(const Eigen::Vector3d& translation,
                                  const Eigen::Vector4d& rotation, const Eigen::Vector3d& scale);

}  // namespace craze
