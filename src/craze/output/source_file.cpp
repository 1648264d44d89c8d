#include "craze/output/source_file.h"

#include <filesystem>

namespace craze {

bool is_shape(std::string_view name) {
  return name.starts_with("shape:");
}

std::vector<MaterialLook> looks_from(const std::vector<MaterialLook>& looks,
                                     const std::string& input, const std::string& output) {
  namespace fs = std::filesystem;
  std::vector<MaterialLook> seen = looks;
  const auto folder_of = [](const std::string& path) {
    std::error_code failed;
    const fs::path folder = fs::weakly_canonical(fs::path(path), failed).parent_path();
    return failed ? fs::path(path).parent_path() : folder;
  };
  const fs::path from = folder_of(input), to = folder_of(output);
  for (MaterialLook& look : seen) {
    for_each_picture(look, [&](LookPicture& picture) {
      if (picture.file.empty()) return;
      picture.file = (from / picture.file).lexically_proximate(to).generic_string();
    });
  }
  return seen;
}

}  // namespace craze
