// A recipe as JSON, for reports and other programs.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "craze/recipe.h"

namespace craze {

/// Every parameter: one object per section, "impact" an array. Reads back equal (read_recipe).
nlohmann::ordered_json recipe_to_json(const Recipe& recipe);

}  // namespace craze
