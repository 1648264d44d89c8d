// Results, on standard output.
#pragma once

#include <string_view>

namespace craze::app {

/// Writes results to standard output and returns the exit code: `failed`, without a word, where a
/// pipe is closed; throws Error(output) where writing fails otherwise.
int print(std::string_view text);

}  // namespace craze::app
