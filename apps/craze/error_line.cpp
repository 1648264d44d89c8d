#include "error_line.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace craze::app {

namespace {

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

}  // namespace

void print_error(const std::string& message) {
  print_line("error", "\x1b[1;31m", message);
}

void print_warning(const std::string& message) {
  print_line("warning", "\x1b[1;33m", message);
}

}  // namespace craze::app
