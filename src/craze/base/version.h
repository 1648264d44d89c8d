// Which craze this is.
#pragma once

#include <string>

namespace craze {

/// "0.1.0", the project's version in CMakeLists.txt.
std::string version();

}  // namespace craze
