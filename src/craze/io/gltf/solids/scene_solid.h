// Solids among the nodes of a scene that is kept.
#pragma once

#include <cstddef>

#include "craze/collider.h"
#include "craze/io/gltf/scene/scene_output.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Says in a node's extras what the solid that it shows is (solid_node.h), and adds the node of its
/// collider below where that is one. `solid` is in the node's axes.
void add_solid(const SurfaceMesh& solid, Collider collider, std::size_t node, SceneOutput& output);

}  // namespace craze
