// What pictures show of a file's own materials.
#pragma once

#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/read_mesh.h"
#include "craze/render/material/look.h"

namespace craze {

/// Textures of which UV sets are shown.
enum class ShownUvs { first, all };

/// The looks of a file with their textures decoded, each once; files that it names are looked for
/// beside `input`. None where no material has a texture or is other than grey: then a picture's
/// material says more. Warns of each texture that cannot be shown, which leaves the factor alone,
/// and of those in further UV sets where these are not shown. Throws Cancelled.
std::vector<render::Look> material_looks(const std::vector<MaterialLook>& looks,
                                         const std::string& input,
                                         std::vector<std::string>& warnings, const Context& context,
                                         ShownUvs uvs = ShownUvs::first);

/// The UVs of the sets 1, 2 … that the looks of a file read, 3 #F of its mesh each; of others none.
/// Warns of sets that the file has not, or that only some faces of a material have.
std::vector<std::vector<Vec2>> further_uvs(const MeshFile& file,
                                           std::vector<std::string>& warnings);

}  // namespace craze
