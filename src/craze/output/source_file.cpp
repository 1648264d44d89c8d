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
  for (MaterialLook& look : seen) {
    if (look.texture_file.empty()) continue;
    const fs::path file = folder_of(input) / look.texture_file;
    look.texture_file = file.lexically_proximate(folder_of(output)).generic_string();
  }
  return seen;
}

}  // namespace craze
