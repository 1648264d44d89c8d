#include "craze/output/source_file.h"

#include <filesystem>

#include "craze/io/files/sibling_files.h"

namespace craze {

bool is_shape(std::string_view name) {
  return name.starts_with("shape:");
}

std::vector<MaterialLook> looks_from(const std::vector<MaterialLook>& looks,
                                     const std::string& input, const std::string& output) {
  namespace fs = std::filesystem;
  std::vector<MaterialLook> seen = looks;
  const auto folder_of = [](const std::string& path) {
    fs::path folder = fs::path(path).parent_path();
    if (folder.empty()) folder = ".";
    std::error_code failed;
    const fs::path whole = fs::weakly_canonical(folder, failed);
    return failed ? folder : whole;
  };
  const fs::path from = folder_of(input), to = folder_of(output);
  for (MaterialLook& look : seen) {
    for_each_picture(look, [&](LookPicture& picture) {
      // What lies elsewhere than in a folder stays as it is named.
      if (picture.file.empty() || picture.file.find("://") != std::string::npos) return;
      const fs::path file = from / decode_percent(picture.file);
      picture.file = file.lexically_proximate(to).generic_string();
    });
  }
  return seen;
}

}  // namespace craze
