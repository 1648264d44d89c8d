#include "error_line.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace craze::app {

void print_error(const std::string& message) {
  std::string line = message;
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  const char* no_color = std::getenv("NO_COLOR");
  const bool color = isatty(STDERR_FILENO) && (!no_color || !*no_color);
  std::fprintf(stderr, "%scraze: error:%s %s\n", color ? "\x1b[1;31m" : "", color ? "\x1b[0m" : "",
               line.c_str());
}

}  // namespace craze::app
