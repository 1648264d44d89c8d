// Colours of options.
#pragma once

#include <array>
#include <string>

namespace craze::app {

/// RRGGBB, hexadecimal, as sRGB 0 … 255. Throws Error(usage), which names the option.
std::array<int, 3> color_of(const std::string& option, const std::string& text);

}  // namespace craze::app
