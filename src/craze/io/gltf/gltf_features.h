// What a glTF file asks of its reader, and which other files it names.
#pragma once

#include "craze/io/gltf/gltf_json.h"
#include "craze/io/mesh_source.h"

namespace craze {

/// Throws Error(input) that names the first extension that the file requires and that changes what
/// its meshes are in a way that is not known here.
void check_required_extensions(const Json& root, const std::string& name);

/// Tells the source the pictures outside the file.
void list_pictures(const Json& root, const MeshSource& source);

}  // namespace craze
