// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 3.9.
#include "craze/io/gltf/scene/scene_pictures.h"

#include <array>
#include <map>
#include <optional>

#include "craze/base/parallel.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/gltf/scene/scene_output.h"
#include "craze/io/gltf/texture_place.h"
#include "craze/io/image/encode_png.h"
#include "craze/io/image/read_image.h"

namespace craze {

namespace {

enum Slot { base_color, normal, occlusion, roughness, slots };

struct SlotPlace {
  const char* object;  ///< of the material that holds it; "": the material itself
  const char* key;
  const char* name;  ///< for sentences and images
};

constexpr std::array<SlotPlace, slots> places{{
    {"pbrMetallicRoughness", "baseColorTexture", "base_color"},
    {"", "normalTexture", "normal"},
    {"", "occlusionTexture", "occlusion"},
    {"pbrMetallicRoughness", "metallicRoughnessTexture", "roughness"},
}};

const Json* find(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found == object.end() ? nullptr : &*found;
}

const Json* find_slot(const Json& material, Slot slot) {
  const SlotPlace& place = places[slot];
  const Json* holder = *place.object == '\0' ? &material : find(material, place.object);
  return holder ? find(*holder, place.key) : nullptr;
}

double number(const Json* object, const char* key, double fallback) {
  const Json* found = object ? find(*object, key) : nullptr;
  return found && found->is_number() ? found->get<double>() : fallback;
}

std::optional<std::size_t> index(const Json* object, const char* key) {
  const Json* found = object ? find(*object, key) : nullptr;
  if (!found || !found->is_number_unsigned()) return {};
  return found->get<std::size_t>();
}

/// The object number i of a list of the document's; null where there is none.
const Json* item(const Json& root, const char* list, std::optional<std::size_t> i) {
  const Json* items = find(root, list);
  return items && items->is_array() && i && *i < items->size() ? &(*items)[*i] : nullptr;
}

/// The UV set that a reference to a texture reads.
std::size_t uv_set_of(const Json& reference) {
  const std::size_t set = index(&reference, "texCoord").value_or(0);
  const Json* moved = GltfJson(document_name).extension(reference, "KHR_texture_transform");
  return index(moved, "texCoord").value_or(set);
}

/// The picture that a texture shows; throws Error where it cannot be read.
SurfacePicture read_picture(const GltfDocument& document, const Json& reference) {
  const auto fail = [](const char* why) {
    throw Error(ErrorKind::request, "cannot use picture", "texture", why);
  };
  SurfacePicture picture;
  const Json* moved = GltfJson(document_name).extension(reference, "KHR_texture_transform");
  if (moved) picture.place = texture_place(*moved, GltfJson(document_name));
  picture.uv_set = uv_set_of(reference);
  const Json& root = document.root();
  const Json* texture = item(root, "textures", index(&reference, "index"));
  const Json* image = item(root, "images", index(texture, "source"));
  if (texture) picture.wraps = texture_wraps(root, *texture);
  if (!image) fail("it is of a kind that is not known here");
  const Json* view = item(root, "bufferViews", index(image, "bufferView"));
  if (!view) fail("its file was not brought");
  const auto begin = static_cast<std::size_t>(number(view, "byteOffset", 0));
  const auto length = static_cast<std::size_t>(number(view, "byteLength", 0));
  if (begin > document.bin().size()) fail("its bytes lie outside the file");
  picture.image = read_image(std::string_view(document.bin()).substr(begin, length), "texture");
  return picture;
}

/// Every texture that anything in the document's materials refers to, once for each time.
void count_textures(const Json& json, std::map<std::size_t, int>& uses) {
  for (const auto& [key, value] : json.items()) {
    if (!value.is_structured()) continue;
    if (key.ends_with("Texture")) {
      if (const auto texture = index(&value, "index")) ++uses[*texture];
    }
    count_textures(value, uses);
  }
}

class PictureWriter {
 public:
  explicit PictureWriter(const GltfDocument& document) : output_(document) {
    Json& root = output_.root;
    if (const Json* materials = find(root, "materials")) count_textures(*materials, textures_);
    if (const Json* textures = find(root, "textures")) {
      for (const Json& texture : *textures) {
        if (const auto image = index(&texture, "source")) ++images_[*image];
      }
    }
  }

  void put(const NewPictures& made, const std::array<std::string, slots>& files) {
    const KeptPictures& kept = made.kept;
    const std::size_t at =
        made.material < 0 ? new_material(made.uv_set) : static_cast<std::size_t>(made.material);
    Json& material = output_.root["materials"][at];
    if (!material.contains("pbrMetallicRoughness")) {
      material["pbrMetallicRoughness"] = Json::object();
    }
    const Json* own_normal = find_slot(material, normal);
    if (!kept[normal] && !made.has_tangents &&
        made.uv_set != (own_normal ? uv_set_of(*own_normal) : 0)) {
      drop_tangents(at);
    }
    Json& surface = material["pbrMetallicRoughness"];
    const std::string name = material.value("name", fmt::format("material_{}", at));
    const auto put_in = [&](Slot slot) {
      Json reference{{"index", put_texture(material, slot, name, files[slot])}};
      if (made.uv_set > 0) reference["texCoord"] = made.uv_set;
      return reference;
    };
    if (!kept[base_color]) surface["baseColorTexture"] = put_in(base_color);
    if (!kept[normal]) material["normalTexture"] = put_in(normal);
    if (kept[roughness]) return;
    const Json reference = put_in(roughness);
    surface["metallicRoughnessTexture"] = reference;
    surface["metallicFactor"] = 1.0;
    surface["roughnessFactor"] = 1.0;
    if (!kept[occlusion]) material["occlusionTexture"] = reference;
  }

  std::string pack() { return output_.pack(); }

 private:
  static Json& list(Json& root, const char* name) {
    if (!root.contains(name)) root[name] = Json::array();
    return root[name];
  }

  /// For the primitives that had none and have that UV set; as glTF shows those.
  std::size_t new_material(std::size_t uv_set) {
    const std::string uvs = "TEXCOORD_" + std::to_string(uv_set);
    Json& materials = list(output_.root, "materials");
    const std::size_t own = materials.size();
    materials.push_back({{"name", "surface"}});
    for (Json& mesh : output_.root["meshes"]) {
      for (Json& primitive : mesh["primitives"]) {
        const double mode = number(&primitive, "mode", 4);
        if (primitive.contains("material") || mode < 4) continue;
        if (primitive["attributes"].contains(uvs)) primitive["material"] = own;
      }
    }
    return own;
  }

  /// Those in the file belong to the UVs that the material's normals lay in.
  void drop_tangents(std::size_t material) {
    for (Json& mesh : output_.root["meshes"]) {
      for (Json& primitive : mesh["primitives"]) {
        if (index(&primitive, "material") != material) continue;
        primitive["attributes"].erase("TANGENT");
        if (!primitive.contains("targets")) continue;
        for (Json& target : primitive["targets"]) target.erase("TANGENT");
      }
    }
  }

  /// The texture that shows the picture from now on: the material's own where only that shows it.
  std::size_t put_texture(const Json& material, Slot slot, const std::string& name,
                          const std::string& file) {
    Json& root = output_.root;
    const Json image{{"name", fmt::format("{}_{}", name, places[slot].name)},
                     {"mimeType", "image/png"},
                     {"bufferView", output_.add_bytes(file)}};
    const Json* reference = find_slot(material, slot);
    const auto texture = reference ? index(reference, "index") : std::nullopt;
    const Json* own = item(root, "textures", texture);
    const auto source = own ? index(own, "source") : std::nullopt;
    // A material's own occlusion may be the same picture.
    const bool shared =
        slot == roughness && index(find_slot(material, occlusion), "index") == texture;
    const int uses = shared ? 2 : 1;
    if (source && !own->contains("extensions") && textures_[*texture] == uses &&
        images_[*source] == 1) {
      root["images"][*source] = image;
      return *texture;
    }
    Json made{{"source", list(root, "images").size()}};
    if (own && own->contains("sampler")) made["sampler"] = (*own)["sampler"];
    root["images"].push_back(image);
    list(root, "textures").push_back(std::move(made));
    return root["textures"].size() - 1;
  }

  SceneOutput output_;
  std::map<std::size_t, int> textures_, images_;  // uses, before anything was changed
};

}  // namespace

MaterialPictures material_pictures(const GltfDocument& document, std::int32_t material,
                                   const std::function<void(const std::string&)>& warn) {
  MaterialPictures result;
  const Json none = Json::object();
  const Json* own = material < 0
                        ? nullptr
                        : item(document.root(), "materials", static_cast<std::size_t>(material));
  const Json& json = own ? *own : none;
  SurfacePictures& pictures = result.pictures;
  const std::array<SurfacePicture*, slots> images{&pictures.base_color, &pictures.normal,
                                                  &pictures.occlusion, &pictures.roughness};
  for (int s = 0; s < slots; ++s) {
    const auto slot = static_cast<Slot>(s);
    const Json* reference = find_slot(json, slot);
    if (!reference) continue;
    try {
      *images[slot] = read_picture(document, *reference);
    } catch (const Error& error) {
      result.kept[slot] = true;
      warn(fmt::format("the picture {} of material '{}' stays without cracks: {}",
                       places[slot].name, json.value("name", ""), error.what()));
    }
  }
  pictures.normal_scale = number(find_slot(json, normal), "scale", 1);
  pictures.occlusion_strength = number(find_slot(json, occlusion), "strength", 1);
  const Json* surface = find(json, "pbrMetallicRoughness");
  pictures.roughness_factor = number(surface, "roughnessFactor", 1);
  pictures.metallic_factor = number(surface, "metallicFactor", 1);
  const Json* factor = surface ? find(*surface, "baseColorFactor") : nullptr;
  if (factor && factor->is_array() && factor->size() == 4) {
    for (std::size_t k = 0; k < 4; ++k) {
      if ((*factor)[k].is_number()) result.base_factor[k] = (*factor)[k].get<float>();
    }
  }
  return result;
}

std::string format_with_pictures(const GltfDocument& document,
                                 const std::vector<NewPictures>& materials,
                                 const Context& context) {
  PictureWriter writer(document);
  for (const NewPictures& made : materials) {
    context.check();
    std::array<std::string, slots> files;
    const std::array<const Image*, slots> images{&made.pictures.base_color.image,
                                                 &made.pictures.normal.image, nullptr,
                                                 &made.pictures.roughness.image};
    parallel_for(context.threads, slots, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        if (images[s] && !made.kept[s]) files[s] = encode_png(*images[s]);
      }
    });
    writer.put(made, files);
  }
  return writer.pack();
}

}  // namespace craze
