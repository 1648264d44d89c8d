#include "craze/io/gltf/gltf_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "craze/io/bytes/input_error.h"

namespace craze {

namespace {

/// Followed, or of no consequence for shapes: how surfaces look, where light comes from, how
/// pictures are packed, what is written about the file.
constexpr const char* known_extensions[] = {"KHR_mesh_quantization", "EXT_mesh_gpu_instancing",
                                            "KHR_texture_transform", "KHR_texture_basisu",
                                            "KHR_lights_punctual",   "KHR_animation_pointer",
                                            "KHR_xmp_json_ld",       "EXT_texture_webp",
                                            "EXT_texture_avif",      "EXT_lights_image_based"};

bool is_known(const std::string& extension) {
  return extension.starts_with("KHR_materials_") ||
         std::find(std::begin(known_extensions), std::end(known_extensions), extension) !=
             std::end(known_extensions);
}

/// Attributes that vertices keep; others are told of by name.
bool is_kept(const std::string& attribute) {
  return attribute == "POSITION" || attribute == "NORMAL" || attribute == "TEXCOORD_0" ||
         attribute == "COLOR_0" || attribute.starts_with('_') || attribute.starts_with("JOINTS_") ||
         attribute.starts_with("WEIGHTS_");
}

/// The kinds of attributes that no mesh keeps, a few of them.
std::set<std::string> lost_attributes(const Json& root, const GltfJson& json) {
  constexpr std::size_t most_named = 8;
  std::set<std::string> lost;
  for (const Json& mesh : json.array(root, "meshes")) {
    if (!mesh.is_object()) continue;
    for (const Json& primitive : json.array(mesh, "primitives")) {
      const auto attributes =
          primitive.is_object() ? primitive.find("attributes") : primitive.end();
      if (attributes == primitive.end() || !attributes->is_object()) continue;
      for (const auto& [key, value] : attributes->items()) {
        if (!is_kept(key) && lost.size() < most_named) lost.insert(printable(key));
      }
    }
  }
  return lost;
}

}  // namespace

void check_required_extensions(const Json& root, const std::string& name) {
  const GltfJson json(name);
  for (const Json& entry : json.array(root, "extensionsRequired")) {
    const std::string extension = entry.is_string() ? entry.get<std::string>() : std::string();
    if (extension == "KHR_draco_mesh_compression") {
      json.fail("it is compressed with Draco, which is not supported; export it without");
    }
    if (extension == "EXT_meshopt_compression" || extension == "KHR_meshopt_compression") {
      json.fail("it is compressed with meshopt, which is not supported; export it without");
    }
    if (!is_known(extension)) {
      json.fail(fmt::format("it requires the extension '{}', which is not supported",
                            printable(extension)));
    }
  }
}

void warn_of_what_is_left_out(const Json& root, const MeshSource& source) {
  const GltfJson json(source.name);
  std::string list;
  const auto add = [&](const std::string& what) { list += (list.empty() ? "" : ", ") + what; };
  const std::pair<const char*, const char*> kinds[] = {{"textures", "textures"},
                                                       {"animations", "animations"},
                                                       {"skins", "skins (applied as they stand)"},
                                                       {"cameras", "cameras"}};
  for (const auto& [key, what] : kinds) {
    if (const std::size_t n = json.array(root, key).size(); n > 0)
      add(fmt::format("{} {}", n, what));
  }
  if (!json.array(root, "materials").empty()) add("materials but for their names");
  for (const std::string& attribute : lost_attributes(root, json)) add(attribute);
  if (!list.empty()) source.warn("a mesh alone is read, not kept: " + list);
  for (const Json& image : json.array(root, "images")) {
    if (!image.is_object()) continue;
    const std::string uri = json.text(image, "uri");
    if (!uri.empty() && !uri.starts_with("data:")) source.textures.push_back(uri);
  }
}

}  // namespace craze
