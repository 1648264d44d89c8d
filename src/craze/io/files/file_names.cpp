#include "craze/io/files/file_names.h"

#include <algorithm>
#include <cctype>
#include <system_error>

namespace craze {

std::string plain_file_name(std::string_view name) {
  constexpr std::string_view blanks = " \t\r\v\f";
  name.remove_prefix(std::min(name.find_first_not_of(blanks), name.size()));
  name = name.substr(0, name.find_last_not_of(blanks) + 1);
  if (name.size() > 1 && name.front() == '"' && name.back() == '"') {
    name = name.substr(1, name.size() - 2);
  }
  std::string plain(name);
  std::replace(plain.begin(), plain.end(), '\\', '/');
  return plain;
}

bool is_absolute_name(const std::string& name) {
  const bool has_drive =
      name.size() > 1 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
  return name.starts_with('/') || has_drive || name.find("://") != std::string::npos;
}

std::filesystem::path whole_path(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  return fs::weakly_canonical(path.empty() ? fs::path(".") : path, ignored);
}

}  // namespace craze
