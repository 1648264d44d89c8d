// Where an output really goes, whatever its name.
#pragma once

#include <filesystem>
#include <string>

namespace craze {

/// The path that symbolic links at `path` lead to in the end, whether there is a file or not; any
/// other path is itself. Throws Error(output) for links that go round.
std::filesystem::path followed(std::filesystem::path path);

/// The same text for every name of one file: links, hard links, "..", relative and absolute paths.
/// Of a file that does not exist yet: its place in the folder that does.
std::string place_of(const std::filesystem::path& path);

}  // namespace craze
