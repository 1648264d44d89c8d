// The one line that says what went wrong.
#pragma once

#include <string>

#include "terminal/message_style.h"

namespace craze::app {

/// Writes "craze: error: MESSAGE" on standard error, control characters replaced by spaces; in red
/// on a terminal unless NO_COLOR is set. As JSON: {"error": MESSAGE}.
void print_error(MessageStyle style, const std::string& message);

/// The same for what was done, but not as asked: "craze: warning: MESSAGE", in yellow.
void print_warning(MessageStyle style, const std::string& message);

/// The same for what is done of itself and may surprise: "craze: note: MESSAGE", in cyan.
void print_note(MessageStyle style, const std::string& message);

/// Says that a signal ended the command: "craze: stopped"; as JSON an error.
void print_stopped(MessageStyle style);

}  // namespace craze::app
