#include "craze/io/files/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "craze/error.h"
#include "craze/io/files/wait_for_pipe.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

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

/// True for names the system lends, such as those /dev/stdout is a link to: even where a regular
/// file is behind them, another program holds it open, and replacing it would write past that
/// program.
bool is_lent(const fs::path& path) {
  const std::string text = path.string();
  return text.starts_with("/dev/fd/") || text.starts_with("/proc/");
}

/// Where a file of that name is, following links; sets `code` to the system's error code.
fs::path place_of(fs::path path, std::error_code& code) {
  constexpr int most_links = 40;  // as the kernel allows
  for (int links = 0; !is_lent(path) && fs::is_symlink(path, code); ++links) {
    if (links == most_links) {
      code = std::make_error_code(std::errc::too_many_symbolic_link_levels);
      return path;
    }
    path = path.parent_path() / fs::read_symlink(path, code);
    if (code) return path;
  }
  code.clear();
  return path;
}

}  // namespace

AtomicFile::AtomicFile(fs::path path, const char* what, Context context)
    : asked_(std::move(path)), what_(what), context_(std::move(context)) {
  std::error_code code;
  place_ = place_of(asked_, code);
  if (code) fail(code.value());
  const fs::file_status status = fs::status(place_, code);
  if (fs::is_directory(status)) fail(EISDIR);
  if (is_lent(place_) || (fs::exists(status) && !fs::is_regular_file(status))) return;
  if (!place_.has_filename()) fail(place_.empty() ? ENOENT : EISDIR);
  beside_.emplace(place_);
  if (beside_->descriptor() < 0) fail(errno);
}

void AtomicFile::fail(int code) const {
  throw Error(ErrorKind::output, what_, asked_.string(), std::generic_category().message(code));
}

void AtomicFile::put(std::string_view bytes) {
  if (!beside_) {
    collected_ += bytes;
  } else if (const int code = write_all(beside_->descriptor(), bytes, context_); code != 0) {
    fail(code);
  }
}

void AtomicFile::finish() {
  if (!beside_) {
    if (const int code = write_directly(place_.c_str(), collected_, context_); code != 0)
      fail(code);
    return;
  }
  struct stat old {};
  if (::stat(place_.c_str(), &old) == 0 &&
      ::fchmod(beside_->descriptor(), old.st_mode & 07777) != 0) {
    fail(errno);
  }
  if (const int code = beside_->move_to(place_); code != 0) fail(code);
}

void write_file(const fs::path& path, std::string_view bytes, const char* what,
                const Context& context) {
  AtomicFile file(path, what, context);
  file.put(bytes);
  file.finish();
}

}  // namespace craze
