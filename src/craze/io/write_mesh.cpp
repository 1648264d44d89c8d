#include "craze/io/write_mesh.h"

#include <algorithm>

#include "craze/base/error.h"
#include "craze/io/atomic_file.h"
#include "craze/io/glb_writer.h"
#include "craze/io/obj.h"
#include "craze/io/ply.h"
#include "craze/io/stl.h"

namespace craze {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh) {
  const char* what = "cannot write mesh";
  const std::string extension = lower_extension(path);
  if (extension == ".ply") {
    write_file(path, format_ply(mesh), what);
  } else if (extension == ".obj") {
    write_file(path, format_obj(mesh), what);
  } else if (extension == ".stl") {
    write_file(path, format_stl(mesh), what);
  } else if (extension == ".glb") {
    write_file(path, format_glb(mesh), what);
  } else {
    throw Error(ErrorKind::usage, what, path.string(),
                "the extension must be .ply, .obj, .stl or .glb");
  }
}

}  // namespace craze
