// Which meshes a glTF scene shows, and where.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/gltf/gltf_json.h"
#include "craze/io/gltf/gltf_nodes.h"

namespace craze {

struct GltfInstance {
  std::size_t mesh = 0;
  Eigen::Matrix4d transform;        ///< to the scene's axes, finite; not for a mesh with a skin
  std::optional<std::size_t> skin;  ///< which places the mesh instead
  const Json* node = nullptr;       ///< that shows it; null where the file has no nodes
  std::size_t node_index = 0;       ///< of that node; of the mesh where there is none
  std::optional<std::size_t> copy;  ///< of the many that the node shows
};

/// The meshes of the default scene, of the first one where none is said to be, of all root nodes
/// where there is no scene, and each mesh once where there is no node; in the order of the node
/// tree. EXT_mesh_gpu_instancing is followed. Throws Error(input) for nodes that do not form a
/// tree and for more instances than `most`.
std::vector<GltfInstance> scene_instances(const Json& root, GltfNodes& nodes,
                                          GltfAccessors& accessors, std::size_t most,
                                          const std::string& name);

}  // namespace craze
