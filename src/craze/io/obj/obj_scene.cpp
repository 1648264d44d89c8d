#include "craze/io/obj/obj_scene.h"

#include <algorithm>

#include "craze/io/files/file_names.h"
#include "craze/io/obj/mtl.h"

namespace craze {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view wall_material = "\nnewmtl crack_wall\nKd 0.25 0.25 0.25\n";

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
    for (const auto& [o, g] : objects) content.names.push_back(object_name(o, g));
  }
  if (!libraries.empty()) all.push_back({"material libraries", libraries});
  SceneContent others{"of the materials", {}, true};
  for (const MtlMaterial& material : parse_mtl(materials)) {
    for (const std::string& keyword : material.others) {
      const auto& told = others.names;
      if (std::find(told.begin(), told.end(), keyword) == told.end()) {
        others.names.push_back(keyword);
      }
    }
  }
  if (!others.names.empty()) all.push_back(std::move(others));
  SceneContent named{"pictures of materials", {}};
  for (const auto& [name, bytes] : pictures) named.names.push_back(name);
  if (!named.names.empty()) all.push_back(std::move(named));
  return all;
}

std::string object_name(const std::string& o, const std::string& g) {
  return o.empty() || g.empty() ? o + g : o + "/" + g;
}

std::vector<OtherName> ObjScene::other_names() const {
  std::vector<OtherName> names;
  for (const auto& [o, g] : objects) {
    if (o.empty() || g.empty()) continue;
    names.push_back({o, object_name(o, g)});
    names.push_back({g, object_name(o, g)});
  }
  return names;
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
    return whole_path(from / plain_file_name(name)) == whole_path(library.file);
  };
  if (std::any_of(scene.libraries.begin(), scene.libraries.end(), is_own)) {
    library.file.replace_filename(path.stem().string() + "_cracks.mtl");
  }
  library.names = library.file.filename().string();
  library.text = rename_pictures(scene.materials, [&](const std::string& name) {
    const std::string plain = plain_file_name(name);
    return is_absolute_name(plain) ? name : (from / plain).lexically_proximate(to).string();
  });
  if (has_walls) library.text += wall_material;
  return library;
}

}  // namespace craze
