// Materials that cracks bring into a document.
#pragma once

#include "craze/io/gltf/gltf_json.h"

namespace craze {

class SceneOutput;

/// A matt dark material for side walls, "crack_wall" or a name like it that is free; its number.
std::size_t add_wall_material(SceneOutput& output);
/// A black one that no light changes, for lines, "crack_line".
std::size_t add_line_material(SceneOutput& output);

}  // namespace craze
