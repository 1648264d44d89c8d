#include "craze/io/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>

#include "craze/base/error.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

/// While one lives, this thread's writes to a closed pipe fail with EPIPE instead of ending the
/// process.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;
  ~NoPipeSignal() {
    const timespec now{};
    if (!was_pending_) sigtimedwait(&pipe_, nullptr, &now);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t pipe_, before_;
  bool was_pending_;
};

/// Writes all bytes; returns 0 or the system's error code.
int write_all(int fd, std::string_view bytes) {
  const NoPipeSignal guard;
  while (!bytes.empty()) {
    const ssize_t put = ::write(fd, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return 0;
}

int write_directly(const char* path, std::string_view bytes) {
  const int fd = ::open(path, O_WRONLY | O_CLOEXEC);
  if (fd < 0) return errno;
  const int code = write_all(fd, bytes);
  return ::close(fd) != 0 && code == 0 ? errno : code;
}

/// An open file of a name nobody has, in the folder of `path`.
int create_beside(const fs::path& path, fs::path& temporary) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    temporary = path.parent_path() / fmt::format(".craze-{}-{}.tmp", ::getpid(), attempt);
    const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
}

int write_beside(const fs::path& path, std::string_view bytes) {
  if (!path.has_filename()) return path.empty() ? ENOENT : EISDIR;
  fs::path temporary;
  const int fd = create_beside(path, temporary);
  if (fd < 0) return errno;
  int code = write_all(fd, bytes);
  struct stat old {};
  if (code == 0 && ::stat(path.c_str(), &old) == 0 && ::fchmod(fd, old.st_mode & 07777) != 0) {
    code = errno;
  }
  if (::close(fd) != 0 && code == 0) code = errno;
  if (code == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) code = errno;
  if (code != 0) ::unlink(temporary.c_str());
  return code;
}

/// True for names the system lends, such as /dev/stdout: even where a regular file is behind
/// them, another program holds it open, and replacing it would write past that program.
bool is_lent(const fs::path& path) {
  const std::string text = path.string();
  return text.starts_with("/dev/") || text.starts_with("/proc/");
}

int write_anywhere(fs::path path, std::string_view bytes) {
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
  return is_lent(path) || is_special ? write_directly(path.c_str(), bytes)
                                     : write_beside(path, bytes);
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes, const char* what) {
  if (const int code = write_anywhere(path, bytes); code != 0) {
    throw Error(ErrorKind::output, what, path.string(), std::generic_category().message(code));
  }
}

}  // namespace craze
