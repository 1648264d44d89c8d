// Meshes that joints place, as they stand in the file.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/gltf/gltf_json.h"
#include "craze/io/gltf/gltf_nodes.h"

namespace craze {

/// Per joint of a skin the matrix that takes a vertex to the scene's axes: the joint's transform
/// times its inverse bind matrix. The transform of the node that shows the mesh has no part in it.
/// Throws Error(input).
std::vector<Eigen::Matrix4d> joint_matrices(const Json& root, std::size_t skin, GltfNodes& nodes,
                                            GltfAccessors& accessors, const std::string& name);

/// What the joints do to the vertices of one primitive.
class GltfSkinning {
 public:
  /// Reads every pair JOINTS_n and WEIGHTS_n, of which there is one. `joints` must outlive this.
  /// Throws Error(input) for a joint that the skin has not.
  GltfSkinning(const Json& attributes, std::size_t vertices,
               const std::vector<Eigen::Matrix4d>& joints, GltfAccessors& accessors,
               const std::string& name);

  /// The mean of the joints' matrices by weight, whatever the weights' sum; the first joint's where
  /// all are zero.
  Eigen::Matrix4d matrix(std::size_t vertex) const;

 private:
  struct Set {
    GltfAccessors::Values joints, weights;
  };
  const std::vector<Eigen::Matrix4d>& joints_;
  std::vector<Set> sets_;
};

}  // namespace craze
