// Numbers from text.
#pragma once

#include <charconv>

namespace craze {

/// std::from_chars, also where the library has it for whole numbers alone.
std::from_chars_result parse_double(const char* first, const char* last, double& value);

}  // namespace craze
