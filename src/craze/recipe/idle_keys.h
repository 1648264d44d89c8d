// Keys of [post] that do nothing for lack of another one.
#pragma once

#include <string>
#include <vector>

#include "craze/recipe.h"

namespace craze {

/// Those that only solid pieces have a use for, where they are not as usual: "post.wedge" …
std::vector<std::string> keys_of_solids(const PostParameters& post);

/// A warning for each lack; lengths resolved, or as they are given. `has_cracks`: there are some
/// that could open.
std::vector<std::string> warnings_of_idle_keys(const PostParameters& post, bool has_cracks);

}  // namespace craze
