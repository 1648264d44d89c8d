// Writing a file whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "craze/context.h"
#include "craze/io/files/file_beside.h"

namespace craze {

/// A file whose bytes are given one part after the other. A regular or new file is written beside
/// its place and renamed, so that a reader never sees a part of it and a failure leaves what was
/// there; a symbolic link keeps pointing where it does. What goes to pipes and devices
/// (/dev/stdout) is kept until it is whole and written directly then; a pipe is waited for. Every
/// function throws Error(output) "WHAT (PATH): WHY" with the system's reason, and Cancelled.
class AtomicFile {
 public:
  /// `what` must outlive it.
  AtomicFile(std::filesystem::path path, const char* what, Context context);
  void put(std::string_view bytes);
  /// Gives the file its place. Without it nothing is left.
  void finish();

 private:
  [[noreturn]] void fail(int code) const;

  std::filesystem::path asked_, place_;
  const char* what_;
  Context context_;
  std::optional<FileBeside> beside_;  // none: a pipe or a device
  std::string collected_;             // for those
};

/// The same with all bytes at once.
void write_file(const std::filesystem::path& path, std::string_view bytes,
                const char* what = "cannot write file", const Context& context = {});

}  // namespace craze
