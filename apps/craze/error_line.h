// The one line that says what went wrong.
#pragma once

#include <string>

namespace craze::app {

/// Writes "craze: error: MESSAGE" on standard error, control characters replaced by spaces; in red
/// on a terminal unless NO_COLOR is set.
void print_error(const std::string& message);

/// The same for what was done, but not as asked: "craze: warning: MESSAGE", in yellow.
void print_warning(const std::string& message);

}  // namespace craze::app
