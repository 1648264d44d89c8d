// Who shows which mesh of a document, and which of them need one of their own.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "craze/io/gltf/scene/cut_scene.h"
#include "craze/io/gltf/scene/scene_output.h"

namespace craze {

/// One appearance of a mesh in the scene that cracks change.
struct Showing {
  std::size_t node = 0, mesh = 0;  ///< of the output
  std::vector<std::size_t> parts;  ///< all of it, by number
};

/// Gives each appearance that is changed a mesh of its own, in the output: the document's where
/// nothing else shows it, else a copy. One of many instances becomes a node below theirs.
std::vector<Showing> separate_showings(const CutScene& cut, GltfAccessors& accessors,
                                       SceneOutput& output);

}  // namespace craze
