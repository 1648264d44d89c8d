// What a program of craze ends with, and what it says when that is no success.
#pragma once

#include <functional>

#include "terminal/message_style.h"

namespace craze::app {

constexpr int done = 0, failed = 1, wrong_usage = 2;

/// What `run` returns. Where it throws, one line on standard error says why, and the code is
/// `wrong_usage` for Error(usage), that of the signal for Cancelled, else `failed`.
int exit_code_of(MessageStyle style, const std::function<int()>& run);

}  // namespace craze::app
