#include "craze/io/write_mesh.h"

#include <algorithm>

#include "craze/base/error.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/gltf/glb_writer.h"
#include "craze/io/obj/obj.h"
#include "craze/io/ply/ply.h"
#include "craze/io/stl/stl.h"

namespace craze {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

void check_mesh_file(const std::filesystem::path& path, bool objects, bool animation) {
  const std::string extension = lower_extension(path);
  if (objects && extension != ".obj" && extension != ".glb") {
    throw Error(
        ErrorKind::usage, "cannot write fragments as objects", path.string(),
        "only .obj and .glb hold several objects" +
            std::string(extension == ".ply" ? "; in .ply each face has its number as fragment"
                                            : ""));
  }
  if (animation && extension != ".glb") {
    throw Error(ErrorKind::usage, "cannot write the growth into the mesh", path.string(),
                "only .glb can move; give --frames for one file per moment");
  }
}

void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh,
                const MeshFileOptions& options) {
  const char* what = "cannot write mesh";
  const std::string extension = lower_extension(path);
  check_mesh_file(path, !options.objects.empty(), options.animation != nullptr);
  if (extension == ".ply") {
    write_file(path, format_ply(mesh), what);
  } else if (extension == ".obj") {
    write_file(path, format_obj(mesh, options.objects), what);
  } else if (extension == ".stl") {
    write_file(path, format_stl(mesh), what);
  } else if (extension == ".glb") {
    write_file(path, format_glb(mesh, {options.animation, options.objects}), what);
  } else {
    throw Error(ErrorKind::usage, what, path.string(),
                "the extension must be .ply, .obj, .stl or .glb");
  }
}

}  // namespace craze
