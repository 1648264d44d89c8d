// One key of a recipe, set by name.
#pragma once

#include <string>

#include "craze/recipe.h"

namespace craze {

/// Sets one key. The value is written as in TOML, except that words need no quotes. impact.N.key
/// changes the N-th impact, counted from 0, or appends one where N is their number. `where` is what
/// errors name. Throws Error(usage); the recipe is then as it was.
void set_key(Recipe& recipe, const std::string& key, const std::string& value,
             const std::string& where);

}  // namespace craze
