// What the bytes of a file hash to.
#pragma once

#include <filesystem>
#include <string>

namespace craze {

/// SHA-256 of a file, a part in memory at a time; of none where it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace craze
