#include "craze/io/files/file_beside.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <string>
#include <utility>

#include "craze/base/text/format.h"
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

}  // namespace

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

/// Tries names nobody has until `make` succeeds with one.
template <class Make>
bool FileBeside::take_name(const Make& make) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    temporary_ = folder_ / fmt::format(".craze-{}-{}.tmp", ::getpid(), attempt);
    if (make()) return true;
    if (errno != EEXIST) break;
  }
  temporary_.clear();
  return false;
}

FileBeside::FileBeside(const fs::path& path) : folder_(path.parent_path()) {
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

FileBeside::~FileBeside() {
  if (fd_ >= 0) ::close(fd_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

std::string FileBeside::path_by(int inherited) const {
  return temporary_.empty() ? fmt::format("/proc/self/fd/{}", inherited) : temporary_.string();
}

int FileBeside::move_to(const fs::path& path) {
  if (temporary_.empty()) {
    const std::string self = path_by(fd_);
    const auto link_to = [&](const fs::path& name) {
      return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    // In one step where nothing is there: a process that is killed leaves no name behind.
    if (link_to(path)) {
      if (::close(std::exchange(fd_, -1)) == 0) return 0;
      const int error = errno;
      ::unlink(path.c_str());
      return error;
    }
    if (errno != EEXIST || !take_name([&] { return link_to(temporary_); })) return errno;
  }
  const int fd = std::exchange(fd_, -1);
  if (::close(fd) != 0 || ::rename(temporary_.c_str(), path.c_str()) != 0) return errno;
  temporary_.clear();
  return 0;
}

}  // namespace craze
