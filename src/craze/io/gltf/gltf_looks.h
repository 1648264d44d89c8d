// The base colours of glTF materials.
#pragma once

#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/mesh_source.h"
#include "craze/material_look.h"

namespace craze {

/// One per material. Textures that are in the file come as their bytes, others by name; those of
/// a kind other than glTF's own two are left out.
/// KHR_texture_transform is followed. Warns of textures that cannot be found. Throws Error(input)
/// where materials break the format.
std::vector<MaterialLook> gltf_looks(const Json& root, GltfAccessors& accessors,
                                     const MeshSource& source);

}  // namespace craze
