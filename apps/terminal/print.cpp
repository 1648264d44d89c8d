#include "terminal/print.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "craze/error.h"
#include "terminal/exit_code.h"

namespace craze::app {

int print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return done;
  if (errno == EPIPE) return failed;
  throw Error(ErrorKind::output, "cannot write", "standard output", std::strerror(errno));
}

}  // namespace craze::app
