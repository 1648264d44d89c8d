#include "craze/io/obj/looks_library.h"

#include "craze/base/text/format.h"
#include "craze/io/obj/mtl.h"

namespace craze {

namespace {

/// Scale and shift of a texture; a turn has no place in MTL.
std::string placed(const Eigen::Matrix<double, 2, 3>& place) {
  std::string options;
  if (place(0, 0) != 1 || place(1, 1) != 1) {
    options += fmt::format("-s {} {} 1 ", place(0, 0), place(1, 1));
  }
  if (place(0, 2) != 0 || place(1, 2) != 0) {
    options += fmt::format("-o {} {} 0 ", place(0, 2), place(1, 2));
  }
  return options;
}

void add(std::string& text, const std::string& name, const MaterialLook& look,
         LookPictures& pictures) {
  const Color& c = look.base_color;
  text += fmt::format("\nnewmtl {}\nKd {} {} {}\nd {}\n", name, c[0], c[1], c[2], c[3]);
  const std::string picture = pictures.name_of(look.base_picture);
  if (!picture.empty()) {
    const TextureWraps& wraps = look.base_picture.wraps;
    const bool clamped = wraps[0] == TextureWrap::clamp && wraps[1] == TextureWrap::clamp;
    text += fmt::format("map_Kd {}{}{}\n", clamped ? "-clamp on " : "",
                        placed(look.base_picture.place), picture);
  }
}

}  // namespace

LooksLibrary looks_library(const std::filesystem::path& path, const SurfaceMesh& mesh,
                           const std::vector<MaterialLook>& looks, LookPictures& pictures) {
  if (mesh.material_names.empty()) return {};
  LooksLibrary library{path, "# craze\n"};
  library.file.replace_extension(".mtl");
  const std::vector<std::string> names = mtl_names(mesh);
  for (std::size_t m = 0; m < names.size(); ++m) {
    MaterialLook wall;
    wall.base_color = {0.25f, 0.25f, 0.25f, 1};
    add(library.text, names[m], m < looks.size() ? looks[m] : wall, pictures);
  }
  return library;
}

}  // namespace craze
