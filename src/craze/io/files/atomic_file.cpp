#include "craze/io/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>
#include <utility>

#include "craze/error.h"
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

/// A file in the folder of `path` that gets its place only when it is whole. Without a name until
/// then where the system can do that, so that not even a kill leaves it behind.
class FileBeside {
 public:
  explicit FileBeside(const fs::path& path) : folder_(path.parent_path()) {
    const char* const folder = folder_.empty() ? "." : folder_.c_str();
    if (::access("/proc/self/fd", X_OK) == 0) {  // by which it is given its name
      fd_ = ::open(folder, O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    }
    if (fd_ >= 0) return;
    take_name([&] {
      fd_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      return fd_ >= 0;
    });
  }
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;
  ~FileBeside() {
    if (fd_ >= 0) ::close(fd_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  /// Negative where it could not be made; errno says why.
  int descriptor() const { return fd_; }

  /// Puts it in the place of `path`; returns 0 or the system's error code.
  int move_to(const fs::path& path) {
    if (temporary_.empty()) {
      const std::string self = fmt::format("/proc/self/fd/{}", fd_);
      const bool named = take_name([&] {
        return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) ==
               0;
      });
      if (!named) return errno;
    }
    const int fd = std::exchange(fd_, -1);
    if (::close(fd) != 0 || ::rename(temporary_.c_str(), path.c_str()) != 0) return errno;
    temporary_.clear();
    return 0;
  }

 private:
  /// Tries names nobody has until `make` succeeds with one.
  template <class Make>
  bool take_name(const Make& make) {
    for (int attempt = 0; attempt < 1000; ++attempt) {
      temporary_ = folder_ / fmt::format(".craze-{}-{}.tmp", ::getpid(), attempt);
      if (make()) return true;
      if (errno != EEXIST) break;
    }
    temporary_.clear();
    return false;
  }

  fs::path folder_, temporary_;
  int fd_ = -1;
};

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
