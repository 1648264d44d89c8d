// What a glTF file asks of its reader, and what is read and not kept.
#pragma once

#include "craze/io/gltf/gltf_json.h"
#include "craze/io/mesh_source.h"

namespace craze {

/// Throws Error(input) that names the first extension that the file requires and that changes what
/// its meshes are in a way that is not known here.
void check_required_extensions(const Json& root, const std::string& name);

/// One sentence on what the file holds and a mesh does not, where there is such a thing.
void warn_of_what_is_left_out(const Json& root, const MeshSource& source);

}  // namespace craze
