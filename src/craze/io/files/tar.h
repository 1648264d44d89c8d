// Archives of files, POSIX.1-1988 (ustar).
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace craze {

/// A file of the archive, padded; its bytes say nothing of when and by whom. The name has at most
/// 100 bytes.
std::string tar_entry(std::string_view name, std::string_view bytes);
/// What ends an archive.
std::string tar_end();

/// Reads an archive file by file.
class TarReader {
 public:
  /// Throws Error(input) where it cannot be opened.
  explicit TarReader(const std::filesystem::path& path);

  /// The next file; false at the end. Throws Error(input) for what is no archive or torn.
  bool next(std::string& name, std::string& bytes);

 private:
  [[noreturn]] void fail(const char* why) const;

  std::filesystem::path path_;
  std::ifstream file_;
};

}  // namespace craze
