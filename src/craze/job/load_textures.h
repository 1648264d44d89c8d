// The pictures that a recipe names.
#pragma once

#include "craze/context.h"
#include "craze/grey_image.h"
#include "craze/recipe.h"

namespace craze {

/// Each once, by the name that the recipe gives. Throws Error(input) and Cancelled.
Textures load_textures(const Recipe& recipe, const Context& context);

}  // namespace craze
