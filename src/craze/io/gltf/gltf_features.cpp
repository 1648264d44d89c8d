#include "craze/io/gltf/gltf_features.h"

#include <algorithm>

#include "craze/base/text/format.h"
#include "craze/io/bytes/data_uri.h"
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

void list_pictures(const Json& root, const MeshSource& source) {
  const GltfJson json(source.name);
  for (const Json& image : json.array(root, "images")) {
    if (!image.is_object()) continue;
    const std::string uri = json.text(image, "uri");
    if (!uri.empty() && !is_data_uri(uri)) source.textures.push_back(uri);
  }
}

}  // namespace craze
