#include "craze/io/gltf/gltf_looks.h"

#include <algorithm>
#include <map>
#include <utility>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/bytes/data_uri.h"
#include "craze/io/gltf/texture_place.h"

namespace craze {

namespace {

const Json* object_in(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_object() ? &*found : nullptr;
}

/// Within the bounds that the format or its extensions have, or that keep sense.
float number_or(const Json& object, const char* key, float fallback, float low = 0,
                float high = 1) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return fallback;
  return static_cast<float>(
      std::clamp(found->get<double>(), static_cast<double>(low), static_cast<double>(high)));
}

/// No slope, and no light, is more.
constexpr float most = 1e6f;

class Looks {
 public:
  Looks(const Json& root, GltfAccessors& accessors, const MeshSource& source)
      : root_(root), accessors_(accessors), source_(source), json_(source.name) {}

  MaterialLook look_of(const Json& material) {
    MaterialLook look;
    // The format's own, where a material does not say.
    look.metallic = look.roughness = 1;
    if (!material.is_object()) return look;
    add_clarity(look, material);
    add_relief(look, material);
    add_emission(look, material);
    const Json* surface = object_in(material, "pbrMetallicRoughness");
    if (!surface) return look;
    double factor[4];
    if (json_.numbers(*surface, "baseColorFactor", factor, 4)) {
      for (std::size_t k = 0; k < 4; ++k) look.base_color[k] = static_cast<float>(factor[k]);
    }
    look.metallic = number_or(*surface, "metallicFactor", 1);
    look.roughness = number_or(*surface, "roughnessFactor", 1);
    add_picture(look, *surface, "baseColorTexture", &MaterialLook::base_picture);
    add_picture(look, *surface, "metallicRoughnessTexture",
                &MaterialLook::metallic_roughness_picture);
    return look;
  }

 private:
  /// How much of what lies behind is seen.
  void add_clarity(MaterialLook& look, const Json& material) {
    const std::string mode = json_.text(material, "alphaMode");
    if (mode == "MASK") look.alpha = MaterialLook::Alpha::cut;
    if (mode == "BLEND") look.alpha = MaterialLook::Alpha::blended;
    look.alpha_cutoff = number_or(material, "alphaCutoff", look.alpha_cutoff);
    const Json* clear = json_.extension(material, "KHR_materials_transmission");
    if (!clear) return;
    look.transmission = number_or(*clear, "transmissionFactor", 0);
    add_picture(look, *clear, "transmissionTexture", &MaterialLook::transmission_picture);
    for (FurtherPicture& further : look.further) {
      if (further.slot == &MaterialLook::transmission_picture) further.factor = look.transmission;
    }
    // A texture that cannot be read could have said that nothing is.
    if (clear->contains("transmissionTexture") && !look.transmission_picture) look.transmission = 0;
  }

  void add_relief(MaterialLook& look, const Json& material) {
    add_picture(look, material, "normalTexture", &MaterialLook::normal_picture);
    add_picture(look, material, "occlusionTexture", &MaterialLook::occlusion_picture);
    if (const Json* normal = object_in(material, "normalTexture")) {
      look.normal_strength = number_or(*normal, "scale", 1, -most, most);
    }
    if (const Json* occlusion = object_in(material, "occlusionTexture")) {
      look.occlusion_strength = number_or(*occlusion, "strength", 1);
    }
  }

  void add_emission(MaterialLook& look, const Json& material) {
    add_picture(look, material, "emissiveTexture", &MaterialLook::emission_picture);
    const Json* strong = json_.extension(material, "KHR_materials_emissive_strength");
    const float strength = strong ? number_or(*strong, "emissiveStrength", 1, 0, most) : 1;
    double factor[3];
    if (!json_.numbers(material, "emissiveFactor", factor, 3)) return;
    for (std::size_t k = 0; k < 3; ++k) {
      look.emission[k] = strength * static_cast<float>(std::clamp(factor[k], 0.0, 1.0));
    }
  }

  /// Puts the picture that `material` names as `key` into its slot; one that reads other UVs than
  /// the first is put aside.
  void add_picture(MaterialLook& look, const Json& material, const char* key,
                   LookPicture MaterialLook::*slot) {
    const Json* reference = object_in(material, key);
    if (!reference) return;
    std::size_t uv_set = json_.index_or(*reference, "texCoord", 0);
    const Json* transform = json_.extension(*reference, "KHR_texture_transform");
    if (transform) uv_set = json_.index_or(*transform, "texCoord", uv_set);
    const auto index = json_.index(*reference, "index");
    if (!index) return;
    const Json& texture = json_.item(root_, "textures", *index);
    const auto image = json_.index(texture, "source");
    if (!image) return;
    LookPicture seen;
    seen.wraps = texture_wraps(root_, texture);
    if (transform) seen.place = texture_place(*transform, json_);
    std::tie(seen.bytes, seen.file) = picture(*image);
    if (uv_set == 0) {
      look.*slot = std::move(seen);
    } else {
      look.further.push_back({slot, std::move(seen), uv_set});
    }
  }

  using Picture = std::pair<std::shared_ptr<const std::string>, std::string>;

  const Picture& picture(std::size_t index) {
    const auto [found, is_new] = pictures_.try_emplace(index);
    if (is_new) {
      try {
        found->second = find_picture(json_.item(root_, "images", index));
      } catch (const Error& e) {
        source_.warn(fmt::format("image {} is not shown in pictures: {}", index, e.what()));
      }
    }
    return found->second;
  }

  Picture find_picture(const Json& image) {
    const auto hold = [](std::string bytes) {
      return Picture{std::make_shared<const std::string>(std::move(bytes)), ""};
    };
    if (const auto view = json_.index(image, "bufferView")) {
      return hold(std::string(accessors_.view(*view)));
    }
    std::string uri = json_.text(image, "uri");
    if (!is_data_uri(uri)) return {nullptr, std::move(uri)};
    auto bytes = decode_data_uri(uri);
    if (!bytes) json_.fail("a data URI is not base64");
    return hold(std::move(*bytes));
  }

  const Json& root_;
  GltfAccessors& accessors_;
  const MeshSource& source_;
  GltfJson json_;
  std::map<std::size_t, Picture> pictures_;  ///< by image
};

}  // namespace

std::vector<MaterialLook> gltf_looks(const Json& root, GltfAccessors& accessors,
                                     const MeshSource& source) {
  Looks reader(root, accessors, source);
  std::vector<MaterialLook> looks;
  for (const Json& material : GltfJson(source.name).array(root, "materials")) {
    looks.push_back(reader.look_of(material));
  }
  return looks;
}

}  // namespace craze
