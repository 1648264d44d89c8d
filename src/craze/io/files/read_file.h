// A whole file in memory.
#pragma once

#include <filesystem>
#include <string>

namespace craze {

/// The bytes of a file; pipes and devices are read to their end. Throws Error(input) "WHAT (PATH):
/// WHY" where the path is missing, a folder or not readable.
std::string read_file(const std::filesystem::path& path, const char* what = "cannot read mesh");

}  // namespace craze
