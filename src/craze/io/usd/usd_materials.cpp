#include "craze/io/usd/usd_materials.h"

#include "craze/base/text/format.h"
#include "craze/io/usd/usd_surface.h"

namespace craze {

namespace {

constexpr const char* scope = "/craze/Materials";

constexpr float grey = 0.8f, wall_grey = 0.25f;  // as in GLB

}  // namespace

const std::string& UsdMaterials::path(std::int32_t face_material) {
  const auto [found, is_new] = paths_.try_emplace(face_material);
  if (!is_new) return found->second;
  const std::string name = face_material < 0 ? "surface" : mesh_.material_names[face_material];
  const std::string identifier = names_.take(name);
  found->second = fmt::format("{}/{}", scope, identifier);
  text_ += fmt::format("        def Material \"{}\"", identifier);
  if (identifier != name) text_ += fmt::format(" (displayName = {})", usd_string(name));
  text_ += "\n        {\n" + surface(name, found->second, face_material) + "        }\n";
  return found->second;
}

std::string UsdMaterials::surface(const std::string& name, const std::string& path,
                                  std::int32_t face_material) const {
  if (options_.looks && face_material >= 0 &&
      static_cast<std::size_t>(face_material) < options_.looks->size()) {
    return usd_surface((*options_.looks)[face_material], path);
  }
  if (name != "crack_wall" && !mesh_.vertex_colors.empty()) return usd_surface_of_colors(path);
  MaterialLook plain;
  const float shade = name == "crack_wall" ? wall_grey : grey;
  plain.base_color = {shade, shade, shade, 1};
  return usd_surface(plain, path);
}

std::string UsdMaterials::text() const {
  if (text_.empty()) return "";
  return "    def Scope \"Materials\"\n    {\n" + text_ + "    }\n";
}

}  // namespace craze
