// The material libraries that an OBJ file names.
#pragma once

#include <string>
#include <vector>

#include "craze/io/mesh_source.h"
#include "craze/io/obj/mtl.h"
#include "craze/io/obj/obj_scene.h"

namespace craze {

/// Brings into the scene what `mtllib` names: one file whose name may hold spaces, or several.
/// Warns where none can be read.
void bring_library(const std::string& names, const MeshSource& source, ObjScene& scene);

/// Brings the pictures of the scene's materials and tells the source how its materials look, by
/// their names. Warns of what cannot be read or understood.
void bring_pictures(const std::vector<std::string>& material_names, const MeshSource& source,
                    ObjScene& scene);

/// How a material looks, its pictures by name.
MaterialLook look_of(const MtlMaterial& material);

}  // namespace craze
