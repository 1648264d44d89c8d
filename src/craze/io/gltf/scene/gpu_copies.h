// Copies of a mesh by EXT_mesh_gpu_instancing that must become nodes.
#pragma once

#include <cstddef>
#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/gltf/scene/scene_output.h"

namespace craze {

struct SeparatedCopies {
  std::vector<std::size_t> nodes;  ///< of the copies asked for, new ones
  bool any_left = true;            ///< whether the node still shows others
};

/// Takes the copies (ascending) of a node out of its instances and makes each a child of it, in
/// their places. The children have no mesh yet.
SeparatedCopies separate_copies(const Json& document, std::size_t node,
                                const std::vector<std::size_t>& copies, GltfAccessors& accessors,
                                SceneOutput& output);

}  // namespace craze
