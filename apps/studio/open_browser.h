// The browser that the desktop opens addresses with.
#pragma once

#include <string>

namespace craze::app {

/// Starts it and does not wait; Ctrl-C in this terminal does not reach it. False where there is no
/// program that knows (xdg-open).
bool open_browser(const std::string& address);

}  // namespace craze::app
