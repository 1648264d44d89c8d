// The pictures that a recipe names.
#pragma once

#include <map>
#include <string>

#include "craze/base/grey_image.h"

namespace craze {

/// By the name that the recipe has for each (stress.texture, material.texture, layer.texture).
using Textures = std::map<std::string, GreyImage>;

}  // namespace craze
