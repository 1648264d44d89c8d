#include "terminal/error_line.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace craze::app {

namespace {

void print_json(const char* kind, const std::string& message) {
  nlohmann::json line;
  line[kind] = message;
  // A path need not be UTF-8; JSON must.
  const auto replace = nlohmann::json::error_handler_t::replace;
  std::fprintf(stderr, "%s\n", line.dump(-1, ' ', false, replace).c_str());
}

void print_line(const char* kind, const char* color, const std::string& message) {
  std::string line = message;
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  const char* no_color = std::getenv("NO_COLOR");
  const bool colored = isatty(STDERR_FILENO) && (!no_color || !*no_color);
  std::fprintf(stderr, "%scraze: %s:%s %s\n", colored ? color : "", kind, colored ? "\x1b[0m" : "",
               line.c_str());
}

void print_message(MessageStyle style, const char* kind, const char* color,
                   const std::string& message) {
  if (style == MessageStyle::json) {
    print_json(kind, message);
  } else {
    print_line(kind, color, message);
  }
}

}  // namespace

void print_error(MessageStyle style, const std::string& message) {
  print_message(style, "error", "\x1b[1;31m", message);
}

void print_warning(MessageStyle style, const std::string& message) {
  print_message(style, "warning", "\x1b[1;33m", message);
}

void print_note(MessageStyle style, const std::string& message) {
  print_message(style, "note", "\x1b[1;36m", message);
}

void print_stopped(MessageStyle style) {
  if (style == MessageStyle::json) {
    print_json("error", "stopped");
  } else {
    std::fputs("craze: stopped\n", stderr);
  }
}

}  // namespace craze::app
