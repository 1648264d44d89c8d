// What of a recipe can be asked of the maps of a mesh that was cracked before.
#pragma once

#include <string>

#include "craze/recipe.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The keys, with commas between them.
std::string bake_keys();

/// apply_set() of such a key. Throws Error(usage).
void apply_bake_set(Recipe& recipe, const std::string& assignment);

/// The recipe's [post] with lengths in the mesh's own unit. Throws Error(usage) for two openings,
/// and Error(request) for lengths that cannot be measured on the mesh.
PostParameters bake_post(const Recipe& recipe, const SurfaceMesh& mesh);

}  // namespace craze
