#include "craze/io/files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>

#include "craze/error.h"
#include "craze/io/files/file_beside.h"
#include "craze/io/files/wait_for_pipe.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

/// While one lives, this thread's writes to a closed pipe fail with EPIPE and those beyond the
/// limit on a file's size with EFBIG, instead of ending the process.
class NoWriteSignals {
 public:
  NoWriteSignals() {
    sigset_t pending;
    sigpending(&pending);
    sigemptyset(&ours_);
    for (const int signal : {SIGPIPE, SIGXFSZ}) {
      if (sigismember(&pending, signal) != 1) sigaddset(&ours_, signal);
    }
    pthread_sigmask(SIG_BLOCK, &ours_, &before_);
  }
  NoWriteSignals(const NoWriteSignals&) = delete;
  NoWriteSignals& operator=(const NoWriteSignals&) = delete;
  ~NoWriteSignals() {
    const timespec now{};
    while (sigtimedwait(&ours_, nullptr, &now) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t ours_, before_;
};

/// Writes all bytes; returns 0 or the system's error code.
int write_all(int fd, std::string_view bytes, const Context& context) {
  constexpr std::size_t most_at_once = std::size_t{1} << 24;  // so that a cancel is heard between
  const NoWriteSignals guard;
  while (!bytes.empty()) {
    if (context.is_cancelled()) throw Cancelled();
    const ssize_t put = ::write(fd, bytes.data(), std::min(bytes.size(), most_at_once));
    if (put < 0 && errno == EINTR) continue;
    if (put < 0 && errno == EAGAIN) {
      wait_for_pipe(fd, PipeEnd::write, context);
      continue;
    }
    if (put < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return 0;
}

int write_directly(const char* path, std::string_view bytes, const Context& context) {
  const int fd = open_for_writing(path, context);
  if (fd < 0) return errno;
  int code = 0;
  try {
    code = write_all(fd, bytes, context);
  } catch (...) {
    ::close(fd);
    throw;
  }
  return ::close(fd) != 0 && code == 0 ? errno : code;
}

int write_beside(const fs::path& path, std::string_view bytes, const Context& context) {
  if (!path.has_filename()) return path.empty() ? ENOENT : EISDIR;
  FileBeside file(path);
  if (file.descriptor() < 0) return errno;
  if (const int code = write_all(file.descriptor(), bytes, context); code != 0) return code;
  struct stat old {};
  if (::stat(path.c_str(), &old) == 0 && ::fchmod(file.descriptor(), old.st_mode & 07777) != 0) {
    return errno;
  }
  return file.move_to(path);
}

/// True for names the system lends, such as /dev/stdout: even where a regular file is behind
/// them, another program holds it open, and replacing it would write past that program.
bool is_lent(const fs::path& path) {
  const std::string text = path.string();
  return text.starts_with("/dev/") || text.starts_with("/proc/");
}

int write_anywhere(fs::path path, std::string_view bytes, const Context& context) {
  constexpr int most_links = 40;  // as the kernel allows
  std::error_code code;
  for (int links = 0; !is_lent(path) && fs::is_symlink(path, code); ++links) {
    if (links == most_links) return ELOOP;
    path = path.parent_path() / fs::read_symlink(path, code);
    if (code) return code.value();
  }
  const fs::file_status status = fs::status(path, code);
  if (fs::is_directory(status)) return EISDIR;
  const bool is_special = fs::exists(status) && !fs::is_regular_file(status);
  return is_lent(path) || is_special ? write_directly(path.c_str(), bytes, context)
                                     : write_beside(path, bytes, context);
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes, const char* what,
                const Context& context) {
  if (const int code = write_anywhere(path, bytes, context); code != 0) {
    throw Error(ErrorKind::output, what, path.string(), std::generic_category().message(code));
  }
}

}  // namespace craze
