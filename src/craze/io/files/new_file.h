// A file written a part at a time, whole or not there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "craze/context.h"
#include "craze/io/files/file_beside.h"

namespace craze {

/// Gets its place in finish(); destroyed before that, nothing is left of it. Throws Error(output)
/// "WHAT (PATH): WHY" with the system's reason, and Cancelled.
class NewFile {
 public:
  /// `what` and `context` must outlive this.
  NewFile(const std::filesystem::path& path, const char* what, const Context& context);

  void append(std::string_view bytes);
  /// Puts bytes over those at `offset`, which are there already.
  void overwrite(std::uint64_t offset, std::string_view bytes);
  void finish();
  /// How long it is.
  std::uint64_t size() const { return size_; }

 private:
  void require(int code) const;

  std::filesystem::path path_;
  const char* what_;
  const Context& context_;
  FileBeside file_;
  std::uint64_t size_ = 0;
};

}  // namespace craze
