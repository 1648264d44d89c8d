// The project's own sources, read as text.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace craze::house {

inline const std::filesystem::path source_dir = CRAZE_SOURCE_DIR;

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Every .h and .cpp below a folder of the tree, in order of name.
inline std::vector<std::filesystem::path> sources_below(const std::string& folder) {
  std::vector<std::filesystem::path> sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_dir / folder)) {
    const auto kind = entry.path().extension();
    if (kind == ".h" || kind == ".cpp") sources.push_back(entry.path());
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

/// What a source includes, in order: the text between the brackets or quotes.
inline std::vector<std::string> includes_of(const std::filesystem::path& source) {
  std::vector<std::string> includes;
  std::istringstream lines(read_text(source));
  const std::string mark = "#include ";
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, mark.size(), mark) != 0) continue;
    const auto end = line.find_first_of(">\"", mark.size() + 1);
    includes.push_back(line.substr(mark.size() + 1, end - mark.size() - 1));
  }
  return includes;
}

}  // namespace craze::house
