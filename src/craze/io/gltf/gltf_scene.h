// Which meshes a glTF scene shows, and where.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "craze/io/gltf/gltf_json.h"

namespace craze {

struct GltfInstance {
  std::size_t mesh = 0;
  Eigen::Matrix4d transform;  ///< to the scene's axes, finite
};

/// The meshes of the default scene, of the first one where none is said to be, of all root nodes
/// where there is no scene, and each mesh once where there is no node; in the order of the node
/// tree. Throws Error(input) for nodes that do not form a tree.
std::vector<GltfInstance> scene_instances(const Json& root, const std::string& name);

}  // namespace craze
