#include "craze/io/obj/looks_library.h"

#include <fmt/format.h>

#include <map>

#include "craze/io/image/picture_type.h"
#include "craze/io/obj/mtl.h"

namespace craze {

namespace {

std::string extension_of(const std::string& bytes) {
  const std::string type = picture_type(bytes);
  return type == "image/jpeg" ? ".jpg" : "." + type.substr(type.find('/') + 1);
}

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

class LibraryWriter {
 public:
  explicit LibraryWriter(const std::filesystem::path& path) : path_(path) {
    library_.file = path;
    library_.file.replace_extension(".mtl");
    library_.text = "# craze\n";
  }

  void add(const std::string& name, const MaterialLook& look) {
    const Color& c = look.base_color;
    library_.text += fmt::format("\nnewmtl {}\nKd {} {} {}\nd {}\n", name, c[0], c[1], c[2], c[3]);
    const std::string picture = picture_of(look);
    if (picture.empty()) return;
    library_.text += fmt::format("map_Kd {}{}\n", placed(look.texture_place), picture);
  }

  LooksLibrary take() { return std::move(library_); }

 private:
  std::string picture_of(const MaterialLook& look) {
    if (!look.texture) return look.texture_file;
    const auto [found, is_new] = names_.try_emplace(look.texture.get());
    if (is_new) {
      found->second = fmt::format("{}_{}{}", path_.stem().string(), library_.pictures.size() + 1,
                                  extension_of(*look.texture));
      library_.pictures.emplace_back(path_.parent_path() / found->second, look.texture);
    }
    return found->second;
  }

  std::filesystem::path path_;
  LooksLibrary library_;
  std::map<const std::string*, std::string> names_;
};

}  // namespace

LooksLibrary looks_library(const std::filesystem::path& path, const SurfaceMesh& mesh,
                           const std::vector<MaterialLook>& looks) {
  if (mesh.material_names.empty()) return {};
  LibraryWriter writer(path);
  const std::vector<std::string> names = mtl_names(mesh);
  for (std::size_t m = 0; m < names.size(); ++m) {
    MaterialLook wall;
    wall.base_color = {0.25f, 0.25f, 0.25f, 1};
    writer.add(names[m], m < looks.size() ? looks[m] : wall);
  }
  return writer.take();
}

}  // namespace craze
