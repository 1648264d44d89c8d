// Recipes that a test changes in a few keys.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "craze/recipe.h"

namespace craze {

/// The recipe with settings as --set takes them.
inline Recipe recipe_with(const std::vector<std::string>& settings, Recipe recipe = {}) {
  for (const std::string& setting : settings) apply_set(recipe, setting);
  return recipe;
}

}  // namespace craze
