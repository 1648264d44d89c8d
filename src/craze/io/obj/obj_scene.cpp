#include "craze/io/obj/obj_scene.h"

#include <algorithm>

#include "craze/io/obj/mtl.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view wall_material = "\nnewmtl crack_wall\nKd 0.25 0.25 0.25\n";

fs::path whole_path(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(path.empty() ? fs::path(".") : path, ignored);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

}  // namespace

std::vector<SceneContent> ObjScene::contents() const {
  std::vector<SceneContent> all;
  if (!objects.empty()) {
    SceneContent& content = all.emplace_back(SceneContent{"objects and groups", {}});
    for (const auto& [o, g] : objects)
      content.names.push_back(o.empty() || g.empty() ? o + g : o + "/" + g);
  }
  if (!libraries.empty()) all.push_back({"material libraries", libraries});
  SceneContent named{"pictures of base colours", {}};
  for (const auto& [name, bytes] : pictures) named.names.push_back(name);
  if (!named.names.empty()) all.push_back(std::move(named));
  return all;
}

ObjLibrary library_beside(const fs::path& path, const ObjScene& scene, const SurfaceMesh& mesh) {
  const auto& names = mesh.material_names;
  const bool has_walls = std::find(names.begin(), names.end(), "crack_wall") != names.end() &&
                         scene.materials.find("newmtl crack_wall") == std::string::npos;
  const fs::path from = whole_path(scene.folder), to = whole_path(path.parent_path());
  if (scene.materials.empty() || (from == to && !has_walls)) {
    return {joined(scene.libraries), {}, ""};
  }
  ObjLibrary library;
  library.file = path.parent_path() / path.stem();
  library.file += ".mtl";
  const auto is_own = [&](const std::string& name) {
    return whole_path(from / name) == whole_path(library.file);
  };
  if (std::any_of(scene.libraries.begin(), scene.libraries.end(), is_own)) {
    library.file.replace_filename(path.stem().string() + "_cracks.mtl");
  }
  library.names = library.file.filename().string();
  library.text = rename_pictures(scene.materials, [&](const std::string& name) {
    return fs::path(name).is_absolute() ? name : (from / name).lexically_relative(to).string();
  });
  if (has_walls) library.text += wall_material;
  return library;
}

}  // namespace craze
