#include "craze/io/read_mesh.h"

#include <fmt/format.h>

#include "craze/io/bytes/input_error.h"
#include "craze/io/files/read_file.h"
#include "craze/io/gltf/gltf.h"
#include "craze/io/obj/obj.h"
#include "craze/io/off/off.h"
#include "craze/io/ply/ply.h"
#include "craze/io/stl/stl.h"
#include "craze/io/write_mesh.h"

namespace craze {

SurfaceMesh read_mesh(const std::filesystem::path& path) {
  const std::string name = path.string();
  const std::string bytes = read_file(path);
  const std::string extension = lower_extension(path);
  if (bytes.empty()) fail_input(name, "it is empty");
  if (bytes.starts_with("glTF") || extension == ".gltf" || extension == ".glb") {
    return read_gltf(bytes, name, load_from_folder(path.parent_path()));
  }
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r") || extension == ".ply") {
    return read_ply(bytes, name);
  }
  if (extension == ".obj") return read_obj(bytes, name);
  if (extension == ".stl") return read_stl(bytes, name);
  if (extension == ".off") return read_off(bytes, name);
  fail_input(name, fmt::format("'{}' is not a known extension (.obj .ply .stl .off .gltf .glb)",
                               printable(extension)));
}

}  // namespace craze
