#include "craze/io/obj/obj_materials.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_encoding.h"
#include "craze/io/files/bring_picture.h"
#include "craze/io/files/file_names.h"

namespace craze {

namespace {

/// Adds the text of a library; false where it cannot be read.
bool bring_text(const std::string& name, const MeshSource& source, std::string& text) {
  if (!source.files) return false;
  try {
    text += decode_text(source.files(plain_file_name(name)), name) + "\n";
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// Collects names for one sentence.
class Named {
 public:
  void add(const std::string& name, const std::string& why = {}) {
    if (!known_.emplace(name, why).second) return;
    constexpr std::size_t most = 8;
    if (known_.size() > most + 1) return;
    text_ += text_.empty() ? "" : known_.size() > most ? " " : ", ";
    text_ += known_.size() > most ? "and more" : fmt::format("'{}'{}", printable(name), why);
  }
  void warn(const MeshSource& source, const char* what) const {
    if (!text_.empty()) source.warn(fmt::format("{}: {}", what, text_));
  }

 private:
  std::map<std::string, std::string> known_;
  std::string text_;
};

LookPicture look_picture(const MtlPicture& picture) {
  LookPicture look;
  look.file = picture.name;
  if (picture.is_clamped) look.wraps.fill(TextureWrap::clamp);
  look.place << picture.scale[0], 0, picture.shift[0], 0, picture.scale[1], picture.shift[1];
  return look;
}

}  // namespace

void bring_library(const std::string& names, const MeshSource& source, ObjScene& scene) {
  const auto& known = scene.libraries;
  if (names.empty() || std::find(known.begin(), known.end(), names) != known.end()) return;
  scene.libraries.push_back(names);
  if (bring_text(names, source, scene.materials)) return;
  std::istringstream words(names);
  bool any = false;
  Named missing;
  for (std::string name; words >> name;) {
    const bool is_there = name != names && bring_text(name, source, scene.materials);
    any |= is_there;
    if (!is_there) missing.add(name);
  }
  if (any) {
    missing.warn(source, "material libraries that cannot be read");
  } else {
    source.warn(
        fmt::format("material library '{}' cannot be read; its materials are known by name alone",
                    printable(names)));
  }
}

MaterialLook look_of(const MtlMaterial& material) {
  MaterialLook look;
  for (std::size_t k = 0; k < 3; ++k) {
    look.base_color[k] = static_cast<float>(material.color[k]);
    look.emission[k] = static_cast<float>(material.emission[k]);
  }
  look.base_color[3] = static_cast<float>(material.opacity);
  if (material.opacity < 1) look.alpha = MaterialLook::Alpha::blended;
  look.roughness = static_cast<float>(material.roughness);
  look.metallic = static_cast<float>(material.metallic);
  look.base_picture = look_picture(material.color_picture);
  look.normal_picture = look_picture(material.normal_picture);
  look.normal_strength = static_cast<float>(material.normal_picture.strength);
  look.emission_picture = look_picture(material.emission_picture);
  return look;
}

void bring_pictures(const std::vector<std::string>& material_names, const MeshSource& source,
                    ObjScene& scene) {
  const std::vector<MtlMaterial> materials = parse_mtl(scene.materials);
  std::map<std::string, MaterialLook> known;
  Named missing, unknown, bounded;
  for (const MtlMaterial& material : materials) {
    known.try_emplace(material.name, look_of(material));
    for (const auto* picture :
         {&material.color_picture, &material.normal_picture, &material.emission_picture}) {
      if (picture->name.empty() || scene.pictures.count(picture->name)) continue;
      BroughtPicture brought = bring_picture(picture->name, source);
      if (brought.why.empty()) {
        scene.pictures[picture->name] = std::move(brought.bytes);
      } else {
        missing.add(picture->name, " (" + brought.why + ")");
      }
    }
    if (material.has_unknown_color) unknown.add(material.name);
    if (material.is_bounded) bounded.add(material.name);
  }
  missing.warn(source, "pictures of materials that cannot be read");
  unknown.warn(source, "materials whose colours (Kd, Ke) are not understood and stay plain");
  bounded.warn(source, "materials with numbers out of range, which are bounded");
  Named unheard;
  for (const std::string& name : material_names) {
    if (known.count(name) == 0) unheard.add(name);
  }
  if (!scene.materials.empty()) unheard.warn(source, "materials that no library has");
  if (!source.looks || materials.empty()) return;
  source.looks->clear();
  for (const std::string& name : material_names) {
    const auto found = known.find(name);
    source.looks->push_back(found == known.end() ? MaterialLook{} : found->second);
  }
}

}  // namespace craze
