// Files by the names that other files give them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace craze {

/// A file's name without blanks and quotes around it, and with / between folders.
std::string plain_file_name(std::string_view name);

/// Whether a name, so written, says where a file is whatever folder it is named from, on any
/// system.
bool is_absolute_name(const std::string& name);

/// The path without links and steps back, as far as it is there; the working folder's for "".
std::filesystem::path whole_path(const std::filesystem::path& path);

}  // namespace craze
