#include "craze/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string>
#include <system_error>

#include "craze/base/error.h"

namespace craze {

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

/// What a file made by open(2) would be allowed: the old file's mode, or 0666 less the umask.
mode_t mode_for(const char* path) {
  struct stat status {};
  if (::stat(path, &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

int write_beside(const std::string& path, std::string_view bytes) {
  std::string temporary = path + ".XXXXXX";
  const int fd = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (fd < 0) return errno;
  int code = write_all(fd, bytes);
  if (code == 0 && ::fchmod(fd, mode_for(path.c_str())) != 0) code = errno;
  if (::close(fd) != 0 && code == 0) code = errno;
  if (code == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) code = errno;
  if (code != 0) ::unlink(temporary.c_str());
  return code;
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes, const char* what) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  int code = 0;
  if (std::filesystem::is_directory(status)) {
    code = EISDIR;
  } else if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    code = write_directly(path.c_str(), bytes);
  } else {
    const bool is_link = std::filesystem::is_symlink(path, ignored);
    const auto target = is_link ? std::filesystem::weakly_canonical(path, ignored) : path;
    code = target.empty() ? ELOOP : write_beside(target.string(), bytes);
  }
  if (code != 0) {
    throw Error(ErrorKind::output, what, path.string(), std::generic_category().message(code));
  }
}

}  // namespace craze
