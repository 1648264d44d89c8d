#include "page_folder.h"

#include <system_error>

#include "craze/error.h"

namespace craze::app {

namespace fs = std::filesystem;

fs::path page_folder() {
  std::error_code none;
  const fs::path here = fs::read_symlink("/proc/self/exe", none).parent_path();
  const fs::path folder = (here / CRAZE_PAGE_FROM_PROGRAM).lexically_normal();
  if (fs::is_regular_file(folder / "index.html", none)) return folder;
  throw Error(ErrorKind::request, "no page to show", folder.string(),
              "this craze was installed without its studio; docs/studio.md says how it is built");
}

}  // namespace craze::app
