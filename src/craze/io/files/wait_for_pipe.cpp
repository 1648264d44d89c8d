#include "craze/io/files/wait_for_pipe.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>

#include <cerrno>

namespace craze {

namespace {

constexpr int look_every = 100;  // milliseconds: how long a cancel may go unheard

bool is_pipe(const char* path) {
  struct stat status {};
  return ::stat(path, &status) == 0 && S_ISFIFO(status.st_mode);
}

}  // namespace

void wait_for_pipe(int descriptor, PipeEnd end, const Context& context) {
  pollfd waiting{descriptor, static_cast<short>(end == PipeEnd::read ? POLLIN : POLLOUT), 0};
  for (;;) {
    if (context.is_cancelled()) throw Cancelled();
    if (::poll(&waiting, 1, look_every) > 0) return;
  }
}

int open_for_writing(const char* path, const Context& context) {
  for (;;) {
    const int fd = ::open(path, O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    // ENXIO: nobody reads the pipe yet.
    if (fd >= 0 || errno != ENXIO || !is_pipe(path)) return fd;
    if (context.is_cancelled()) throw Cancelled();
    ::poll(nullptr, 0, look_every);
  }
}

}  // namespace craze
