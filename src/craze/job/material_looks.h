// What pictures show of a file's own materials.
#pragma once

#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/read_mesh.h"
#include "craze/render/material/look.h"

namespace craze {

/// The looks of a file with their textures decoded, each once; files that it names are looked for
/// beside `input`. None where no material has a texture or is other than grey: then a picture's
/// material says more. Warns of each texture that cannot be shown, which leaves the factor alone.
/// Throws Cancelled.
std::vector<render::Look> material_looks(const std::vector<MaterialLook>& looks,
                                         const std::string& input,
                                         std::vector<std::string>& warnings,
                                         const Context& context);

}  // namespace craze
