#include "craze/io/files/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "craze/error.h"
#include "craze/io/files/file_beside.h"
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

/// True for names the system lends, such as those /dev/stdout is a link to: even where a regular
/// file is behind them, another program holds it open, and replacing it would write past that
/// program.
bool is_lent(const fs::path& path) {
  const std::string text = path.string();
  return text.starts_with("/dev/fd/") || text.starts_with("/proc/");
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
