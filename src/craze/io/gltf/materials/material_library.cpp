#include "craze/io/gltf/materials/material_library.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "craze/io/gltf/first_uvs.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/io/image/picture_type.h"
#include "craze/io/obj/obj_materials.h"
#include "craze/io/obj/obj_scene.h"
#include "craze/io/ply/ply_scene.h"

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

/// Textures of pictures in memory, each pair of picture and kind of repetition once.
class PictureTextures {
 public:
  PictureTextures(MaterialLibrary& library, const std::map<std::string, std::string>& pictures)
      : library_(library), pictures_(pictures) {}

  /// A reference to the texture; null where the picture's bytes are not there.
  ordered_json reference(const LookPicture& look) {
    const auto picture = pictures_.find(look.file);
    if (picture == pictures_.end()) return {};
    const auto [texture, is_new] =
        textures_.try_emplace({picture->first, look.wraps}, library_.textures.size());
    if (is_new) add(*picture, look.wraps);
    ordered_json json{{"index", texture->second}};
    const auto& p = look.place;
    if (!p.isIdentity(0)) {
      // v counts upwards there: 1 − v is scaled and shifted.
      json["extensions"]["KHR_texture_transform"] = {{"offset", {p(0, 2), 1 - p(1, 1) - p(1, 2)}},
                                                     {"scale", {p(0, 0), p(1, 1)}}};
    }
    return json;
  }

 private:
  void add(const std::pair<const std::string, std::string>& picture, const TextureWraps& wraps) {
    library_.textures.push_back({{"source", library_.images.size()}});
    if (wraps[0] == TextureWrap::clamp) {
      constexpr int clamp_to_edge = 33071;
      library_.textures.back()["sampler"] = library_.samplers.size();
      library_.samplers.push_back({{"wrapS", clamp_to_edge}, {"wrapT", clamp_to_edge}});
    }
    library_.images.push_back(
        {{"name", picture.first}, {"mimeType", picture_type(picture.second)}});
    library_.image_bytes.push_back(picture.second);
  }

  MaterialLibrary& library_;
  const std::map<std::string, std::string>& pictures_;
  std::map<std::pair<std::string, TextureWraps>, std::size_t> textures_;
};

void add_emission(ordered_json& material, const std::array<double, 3>& emission,
                  const ordered_json& texture) {
  const double strength = std::max({1.0, emission[0], emission[1], emission[2]});
  std::array<double, 3> factor = emission;
  for (double& channel : factor) channel /= strength;
  if (factor == std::array{0.0, 0.0, 0.0}) return;
  material["emissiveFactor"] = factor;
  if (!texture.is_null()) material["emissiveTexture"] = texture;
  if (strength > 1) {
    material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
  }
}

ordered_json material_of(const MtlMaterial& mtl, PictureTextures& textures) {
  const auto& [r, g, b] = mtl.color;
  const MaterialLook look = look_of(mtl);
  ordered_json material{{"name", mtl.name},
                        {"pbrMetallicRoughness",
                         {{"baseColorFactor", {r, g, b, mtl.opacity}},
                          {"metallicFactor", mtl.metallic},
                          {"roughnessFactor", mtl.roughness}}},
                        {"doubleSided", true}};
  if (mtl.opacity < 1) material["alphaMode"] = "BLEND";
  if (const ordered_json color = textures.reference(look.base_picture); !color.is_null()) {
    material["pbrMetallicRoughness"]["baseColorTexture"] = color;
  }
  if (ordered_json normal = textures.reference(look.normal_picture); !normal.is_null()) {
    if (mtl.normal_picture.strength != 1) normal["scale"] = mtl.normal_picture.strength;
    material["normalTexture"] = std::move(normal);
  }
  add_emission(material, mtl.emission, textures.reference(look.emission_picture));
  return material;
}

MaterialLibrary of_obj(const ObjScene& scene, const SurfaceMesh& mesh) {
  MaterialLibrary library;
  std::map<std::string, MtlMaterial> known;
  for (MtlMaterial& material : parse_mtl(scene.materials)) {
    known.try_emplace(material.name, material);
  }
  PictureTextures textures(library, scene.pictures);
  for (const std::string& name : mesh.material_names) {
    const auto found = known.find(name);
    library.materials.push_back(found == known.end() ? ordered_json()
                                                     : material_of(found->second, textures));
  }
  return library;
}

MaterialLibrary of_ply(const PlyScene& scene, const SurfaceMesh& mesh) {
  MaterialLibrary library;
  PictureTextures textures(library, scene.pictures);
  for (std::size_t m = 0; m < scene.looks.size() && m < mesh.material_names.size(); ++m) {
    ordered_json texture = textures.reference(scene.looks[m].base_picture);
    ordered_json& material = library.materials.emplace_back();
    if (texture.is_null()) continue;
    material = {{"name", mesh.material_names[m]},
                {"pbrMetallicRoughness",
                 {{"baseColorTexture", std::move(texture)},
                  {"metallicFactor", 0.0},
                  {"roughnessFactor", 0.8}}},
                {"doubleSided", true}};
  }
  return library;
}

}  // namespace

MaterialLibrary material_library(const SourceScene* scene, const SurfaceMesh& mesh) {
  if (const auto* document = dynamic_cast<const GltfDocument*>(scene)) {
    return of_document(*document);
  }
  if (const auto* obj = dynamic_cast<const ObjScene*>(scene)) return of_obj(*obj, mesh);
  if (const auto* ply = dynamic_cast<const PlyScene*>(scene)) return of_ply(*ply, mesh);
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
