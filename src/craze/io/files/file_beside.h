// A file that gets its place only when it is whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "craze/context.h"

namespace craze {

/// Writes all bytes to a descriptor; returns 0 or the system's error code. A closed pipe and a
/// limit on file sizes are such codes, not ends of the process. Throws Cancelled.
int write_all(int fd, std::string_view bytes, const Context& context);

/// A file in the folder of `path` that gets its place only when it is whole. Without a name until
/// then where the system can do that, so that not even a kill leaves it behind.
class FileBeside {
 public:
  explicit FileBeside(const std::filesystem::path& path);
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;
  /// Unless it was moved, nothing is left of it.
  ~FileBeside();

  /// Open for writing; negative where it could not be made: errno says why.
  int descriptor() const { return fd_; }

  /// What another process opens to write it, where `inherited` is the number that the descriptor
  /// has there.
  std::string path_by(int inherited) const;

  /// Puts it in the place of `path`; returns 0 or the system's error code.
  int move_to(const std::filesystem::path& path);

 private:
  template <class Make>
  bool take_name(const Make& make);

  std::filesystem::path folder_, temporary_;
  int fd_ = -1;
};

}  // namespace craze
