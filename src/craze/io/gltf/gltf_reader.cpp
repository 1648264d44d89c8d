// Format: Khronos Group, "glTF 2.0 Specification", 2021.
#include "craze/io/bytes/byte_order.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/gltf/gltf.h"
#include "craze/io/gltf/gltf_builder.h"

namespace craze {

namespace {

/// What a file may expand to, besides twice its bytes: enough for a scene of small instances.
constexpr std::size_t free_elements = 4'000'000;

struct Chunks {
  std::string_view json, bin;
};

/// A GLB's two chunks; a text file is all JSON.
Chunks split_chunks(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  if (bytes.size() < 20) fail_input(name, "it is too short for GLB");
  if (load<std::uint32_t>(bytes.data() + 4) != 2) fail_input(name, "it is not GLB version 2");
  Chunks chunks;
  std::size_t at = 12;
  while (bytes.size() - at >= 8) {
    const std::size_t size = load<std::uint32_t>(bytes.data() + at);
    const std::string_view type = bytes.substr(at + 4, 4);
    at += 8;
    if (size > bytes.size() - at) fail_input(name, "it ends within a chunk");
    const std::string_view content = bytes.substr(at, size);
    if (type == "JSON" && chunks.json.empty()) chunks.json = content;
    if (type == std::string_view("BIN\0", 4) && chunks.bin.empty()) chunks.bin = content;
    at += size;
  }
  return chunks;
}

void check_version(const Json& root, const GltfJson& json) {
  const auto asset = root.is_object() ? root.find("asset") : root.end();
  if (asset == root.end() || !asset->is_object() ||
      !json.text(*asset, "version").starts_with("2")) {
    json.fail("it is not glTF version 2");
  }
}

}  // namespace

SurfaceMesh read_gltf(std::string_view bytes, const std::string& name, const GltfLoader& loader) {
  const Chunks chunks = split_chunks(bytes, name);
  const Json root = parse_json(chunks.json, name);
  check_version(root, GltfJson(name));
  GltfAccessors accessors(root, chunks.bin, loader, name);
  GltfBuilder builder(root, accessors, name, free_elements + 2 * bytes.size());
  for (const GltfInstance& instance : scene_instances(root, name)) builder.add(instance);
  return builder.finish();
}

}  // namespace craze
