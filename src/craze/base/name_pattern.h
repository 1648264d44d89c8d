// Patterns of names: * stands for any letters, ? for one.
#pragma once

#include <string_view>

namespace craze {

/// Whether the pattern fits the whole name. Both are UTF-8; capitals are other letters than small
/// ones. Time: at most the product of the lengths.
bool fits_pattern(std::string_view name, std::string_view pattern);

}  // namespace craze
