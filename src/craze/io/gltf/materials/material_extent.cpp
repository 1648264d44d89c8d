#include "craze/io/gltf/materials/material_extent.h"

#include <algorithm>
#include <string>
#include <vector>

namespace craze {

namespace {

using Keys = std::vector<std::string>;

bool is_among(const std::string& key, const Keys& keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

bool is_empty(const Json& value) {
  return value.is_structured() && value.empty();
}

bool has_further(const Json& object, const Keys& known) {
  for (const auto& [key, value] : object.items()) {
    if (!is_among(key, known) && !is_empty(value)) return true;
  }
  return false;
}

/// Another UV set, or an extension that does not move the texture without turning it.
bool is_placed_beyond(const Json& texture) {
  if (!texture.is_object()) return false;
  if (texture.value("texCoord", Json(0)) != Json(0)) return true;
  const auto extensions = texture.find("extensions");
  if (extensions == texture.end() || !extensions->is_object()) return false;
  for (const auto& [name, value] : extensions->items()) {
    if (name != "KHR_texture_transform" || !value.is_object()) return true;
    if (value.value("rotation", Json(0)) != Json(0) || value.contains("texCoord")) return true;
  }
  return false;
}

bool says_more_alone(const Json& material, MaterialExtent extent) {
  if (!material.is_object()) return false;
  Keys known{"name",        "pbrMetallicRoughness", "alphaMode",
             "alphaCutoff", "doubleSided",          "emissiveFactor"},
      of_surface{"baseColorFactor", "baseColorTexture", "metallicFactor", "roughnessFactor"},
      extensions;
  if (extent == MaterialExtent::surface) {
    known.insert(known.end(), {"normalTexture", "occlusionTexture", "emissiveTexture"});
    of_surface.emplace_back("metallicRoughnessTexture");
    extensions = {"KHR_materials_transmission", "KHR_materials_emissive_strength"};
  }
  const auto own = material.find("extensions");
  if (own != material.end() && own->is_object()) {
    // An empty one says something by being there: KHR_materials_unlit.
    for (const auto& [name, value] : own->items()) {
      if (!is_among(name, extensions)) return true;
    }
  }
  known.emplace_back("extensions");
  if (has_further(material, known)) return true;
  for (const auto& [key, value] : material.items()) {
    if (key.ends_with("Texture") && is_placed_beyond(value)) return true;
  }
  const auto surface = material.find("pbrMetallicRoughness");
  if (surface != material.end() && surface->is_object()) {
    if (has_further(*surface, of_surface)) return true;
    for (const auto& [key, value] : surface->items()) {
      if (key.ends_with("Texture") && is_placed_beyond(value)) return true;
    }
    if (extent == MaterialExtent::color) {
      for (const char* factor : {"metallicFactor", "roughnessFactor"}) {
        if (surface->value(factor, Json(1)) != Json(1)) return true;
      }
    }
  }
  if (extent == MaterialExtent::surface) return false;
  const Json black{0, 0, 0};
  return material.value("alphaMode", Json()) == Json("MASK") ||
         material.value("emissiveFactor", black) != black;
}

}  // namespace

bool says_more(const Json& root, MaterialExtent extent) {
  const auto materials = root.find("materials");
  if (materials == root.end() || !materials->is_array()) return false;
  return std::any_of(materials->begin(), materials->end(),
                     [&](const Json& material) { return says_more_alone(material, extent); });
}

}  // namespace craze
