// What a file's name says of its format.
#pragma once

#include <filesystem>
#include <string>

namespace craze {

/// The extension in lower case with its dot: ".PLY" and ".ply" are the same format.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace craze
