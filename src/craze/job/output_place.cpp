#include "craze/job/output_place.h"

#include <sys/stat.h>

#include <system_error>

#include "craze/base/text/format.h"
#include "craze/error.h"

namespace craze {

namespace fs = std::filesystem;

fs::path followed(fs::path path) {
  constexpr int most_links = 40;  // as the kernel allows
  std::error_code code;
  const fs::path asked = path;
  for (int links = 0; fs::is_symlink(path, code); ++links) {
    if (links < most_links) path = path.parent_path() / fs::read_symlink(path, code);
    if (links == most_links || code) {
      const std::error_code why =
          code ? code : std::make_error_code(std::errc::too_many_symbolic_link_levels);
      throw Error(ErrorKind::output, "cannot write", asked.string(), why.message());
    }
  }
  return path;
}

std::string place_of(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return fmt::format("{}:{}", status.st_dev, status.st_ino);
  const fs::path target = followed(path);
  const fs::path parent = target.parent_path();
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(parent.empty() ? fs::path(".") : parent, ignored);
  // A folder by its own number, so that it has one name where it is mounted twice.
  if (::stat(folder.c_str(), &status) == 0) {
    return fmt::format("{}:{}/{}", status.st_dev, status.st_ino, target.filename().string());
  }
  return (folder / target.filename()).string();
}

}  // namespace craze
