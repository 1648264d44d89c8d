// How much a glTF material says, for formats that know less.
#pragma once

#include "craze/io/gltf/gltf_json.h"

namespace craze {

/// What a format can say of a material besides its name.
enum class MaterialExtent {
  color,    ///< base colour with its texture, opacity
  surface,  ///< that, metalness, roughness, normals, occlusion, emission, what is transmitted
};

/// Whether some material of a document says more than that, or lies in further UVs. What a file
/// says that is the same without it does not count.
bool says_more(const Json& root, MaterialExtent extent);

}  // namespace craze
