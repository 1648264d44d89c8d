#include "craze/job/dataset/scene/mesh_folder.h"

#include <algorithm>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/mesh_formats.h"

namespace craze {

namespace fs = std::filesystem;

std::vector<std::string> meshes_in(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code failed, ignored;
  for (fs::directory_iterator i(folder, failed), end; !failed && i != end; i.increment(failed)) {
    const MeshFormat* const format = find_mesh_format(i->path().extension().string());
    if (format && format->read && i->is_regular_file(ignored)) files.push_back(i->path().string());
  }
  if (failed) {
    throw Error(ErrorKind::input, "cannot read the folder of meshes", folder.string(),
                failed.message());
  }
  if (files.empty()) {
    std::string known;
    for (const MeshFormat& format : mesh_formats()) {
      if (format.read) known += fmt::format(" .{}", format.name);
    }
    throw Error(ErrorKind::input, "no meshes in the folder", folder.string(),
                "put files there that end with" + known);
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace craze
