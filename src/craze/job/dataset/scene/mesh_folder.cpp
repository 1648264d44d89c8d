#include "craze/job/dataset/scene/mesh_folder.h"

#include <algorithm>

#include "craze/error.h"
#include "craze/io/files/extension.h"

namespace craze {

namespace fs = std::filesystem;

std::vector<std::string> meshes_in(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code failed, ignored;
  for (fs::directory_iterator i(folder, failed), end; !failed && i != end; i.increment(failed)) {
    const std::string kind = lower_extension(i->path());
    for (const char* known : {".obj", ".ply", ".stl", ".off", ".gltf", ".glb"}) {
      if (kind == known && i->is_regular_file(ignored)) files.push_back(i->path().string());
    }
  }
  if (failed) {
    throw Error(ErrorKind::input, "cannot read the folder of meshes", folder.string(),
                failed.message());
  }
  if (files.empty()) {
    throw Error(ErrorKind::input, "no meshes in the folder", folder.string(),
                "put .obj .ply .stl .off .gltf or .glb files there");
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace craze
