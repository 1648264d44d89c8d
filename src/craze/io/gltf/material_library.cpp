#include "craze/io/gltf/material_library.h"

#include <array>
#include <map>
#include <set>

#include "craze/io/gltf/first_uvs.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/io/image/picture_type.h"
#include "craze/io/obj/mtl.h"
#include "craze/io/obj/obj_scene.h"

namespace craze {

namespace {

using nlohmann::ordered_json;

ordered_json list_of(const Json& root, const char* name) {
  return root.contains(name) ? ordered_json::parse(root[name].dump()) : ordered_json::array();
}

MaterialLibrary of_document(const GltfDocument& document) {
  MaterialLibrary library;
  const Json& root = document.root();
  library.materials = list_of(root, "materials");
  keep_first_uvs(library.materials);
  library.textures = list_of(root, "textures");
  library.samplers = list_of(root, "samplers");
  library.images = list_of(root, "images");
  for (ordered_json& image : library.images) {
    std::string& bytes = library.image_bytes.emplace_back();
    if (!image.contains("bufferView")) continue;
    const Json& view = root["bufferViews"][image["bufferView"].get<std::size_t>()];
    bytes = document.bin().substr(view.value("byteOffset", std::size_t{0}),
                                  view["byteLength"].get<std::size_t>());
    image.erase("bufferView");
  }
  return library;
}

ordered_json material_of(const MtlMaterial& mtl, MaterialLibrary& library,
                         std::map<std::string, std::size_t>& textures,
                         const std::map<std::string, std::string>& pictures) {
  const auto& [r, g, b] = mtl.color;
  ordered_json material{{"name", mtl.name},
                        {"pbrMetallicRoughness",
                         {{"baseColorFactor", {r, g, b, mtl.opacity}},
                          {"metallicFactor", 0.0},
                          {"roughnessFactor", 0.8}}},
                        {"doubleSided", true}};
  if (mtl.opacity < 1) material["alphaMode"] = "BLEND";
  const auto picture = pictures.find(mtl.color_picture);
  if (picture == pictures.end()) return material;
  const std::string key = (mtl.is_clamped ? "clamp " : "repeat ") + picture->first;
  const auto [texture, is_new] = textures.try_emplace(key, library.textures.size());
  if (is_new) {
    library.textures.push_back({{"source", library.images.size()}});
    if (mtl.is_clamped) {
      constexpr int clamp_to_edge = 33071;
      library.textures.back()["sampler"] = library.samplers.size();
      library.samplers.push_back({{"wrapS", clamp_to_edge}, {"wrapT", clamp_to_edge}});
    }
    library.images.push_back(
        {{"name", picture->first}, {"mimeType", picture_type(picture->second)}});
    library.image_bytes.push_back(picture->second);
  }
  ordered_json& reference = material["pbrMetallicRoughness"]["baseColorTexture"];
  reference = {{"index", texture->second}};
  if (mtl.scale != std::array{1.0, 1.0} || mtl.shift != std::array{0.0, 0.0}) {
    // MTL counts v upwards: 1 − v is scaled and shifted.
    reference["extensions"]["KHR_texture_transform"] = {
        {"offset", {mtl.shift[0], 1 - mtl.scale[1] - mtl.shift[1]}}, {"scale", mtl.scale}};
  }
  return material;
}

MaterialLibrary of_obj(const ObjScene& scene, const SurfaceMesh& mesh) {
  MaterialLibrary library;
  std::map<std::string, MtlMaterial> known;
  for (MtlMaterial& material : parse_mtl(scene.materials)) {
    known.try_emplace(material.name, material);
  }
  std::map<std::string, std::size_t> textures;
  for (const std::string& name : mesh.material_names) {
    const auto found = known.find(name);
    library.materials.push_back(
        found == known.end() ? ordered_json()
                             : material_of(found->second, library, textures, scene.pictures));
  }
  return library;
}

}  // namespace

MaterialLibrary material_library(const SourceScene* scene, const SurfaceMesh& mesh) {
  if (const auto* document = dynamic_cast<const GltfDocument*>(scene)) {
    return of_document(*document);
  }
  if (const auto* obj = dynamic_cast<const ObjScene*>(scene)) return of_obj(*obj, mesh);
  return {};
}

std::vector<std::string> extensions_of(const ordered_json& json) {
  std::set<std::string> names;
  const auto collect = [&](const auto& self, const ordered_json& in) -> void {
    if (in.is_object() && in.contains("extensions")) {
      for (const auto& [name, value] : in["extensions"].items()) names.insert(name);
    }
    if (!in.is_structured()) return;
    for (const ordered_json& item : in) self(self, item);
  };
  collect(collect, json);
  return {names.begin(), names.end()};
}

}  // namespace craze
