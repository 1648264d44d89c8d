// Keys of a recipe that contradict each other.
#pragma once

#include "craze/recipe.h"

namespace craze {

/// Throws Error(usage) where a recipe says one thing in two ways: post.gap and post.gap_width, or
/// the place of an impact by more than one of point, direction and uv.
void check_recipe(const Recipe& recipe);

}  // namespace craze
