#include "craze/io/files/file_beside.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

namespace craze {

FileBeside::FileBeside(const std::filesystem::path& path) : folder_(path.parent_path()) {
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

int FileBeside::move_to(const std::filesystem::path& path) {
  if (temporary_.empty()) {
    const std::string self = path_by(fd_);
    const bool named = take_name([&] {
      return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) == 0;
    });
    if (!named) return errno;
  }
  const int fd = std::exchange(fd_, -1);
  if (::close(fd) != 0 || ::rename(temporary_.c_str(), path.c_str()) != 0) return errno;
  temporary_.clear();
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

}  // namespace craze
