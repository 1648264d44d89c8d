#include "craze/io/files/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "craze/error.h"
#include "craze/io/files/wait_for_pipe.h"

namespace craze {

namespace {

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_;
};

}  // namespace

std::string read_file(const std::filesystem::path& path, const char* what, const Context& context) {
  const auto fail = [&](int code) {
    throw Error(ErrorKind::input, what, path.string(), std::generic_category().message(code));
  };
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0) fail(errno);
  if (S_ISDIR(status.st_mode)) fail(EISDIR);
  const bool is_regular = S_ISREG(status.st_mode);

  // One byte more than the file is said to hold, so that its end is seen without growing.
  constexpr std::size_t chunk = std::size_t{1} << 16;
  constexpr std::size_t most_at_once = std::size_t{1} << 24;  // so that a cancel is heard between
  std::string bytes(std::max(chunk, static_cast<std::size_t>(status.st_size) + 1), '\0');
  std::size_t size = 0;
  for (;;) {
    if (size == bytes.size()) bytes.resize(2 * size);
    // Before anybody writes to a pipe, a read would take it for one at its end.
    if (!is_regular) wait_for_pipe(file.get(), PipeEnd::read, context);
    if (context.is_cancelled()) throw Cancelled();
    const ssize_t got =
        ::read(file.get(), bytes.data() + size, std::min(bytes.size() - size, most_at_once));
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (got < 0) fail(errno);
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace craze
