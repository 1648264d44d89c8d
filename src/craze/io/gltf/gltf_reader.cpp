// Format: Khronos Group, "glTF 2.0 Specification", 2021.

#include <algorithm>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/gltf/gltf.h"
#include "craze/io/gltf/gltf_builder.h"
#include "craze/io/gltf/gltf_features.h"
#include "craze/io/gltf/gltf_looks.h"

namespace craze {

namespace {

/// What a file may expand to, besides twice its bytes: enough for a scene of small instances.
constexpr std::size_t free_elements = 4'000'000;

struct Chunks {
  std::string_view json, bin;
  std::size_t unread = 0;  ///< bytes after the file's own end
};

/// A GLB's two chunks; a text file is all JSON.
Chunks split_chunks(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with("glTF")) return {bytes, {}, 0};
  if (bytes.size() < 20) fail_input(name, "it is too short for GLB");
  if (load<std::uint32_t>(bytes.data() + 4) != 2) fail_input(name, "it is not GLB version 2");
  Chunks chunks;
  std::size_t at = 12;
  // Bytes after the file's own end are not its.
  const std::size_t end =
      std::min<std::size_t>(bytes.size(), load<std::uint32_t>(bytes.data() + 8));
  chunks.unread = bytes.size() - end;
  while (at < end && bytes.size() - at >= 8) {
    const std::size_t size = load<std::uint32_t>(bytes.data() + at);
    const std::string_view type = bytes.substr(at + 4, 4);
    at += 8;
    if (size > bytes.size() - at) fail_input(name, "it ends within a chunk");
    const std::string_view content = bytes.substr(at, size);
    if (type == "JSON" && chunks.json.empty()) chunks.json = content;
    if (type == std::string_view("BIN\0", 4) && chunks.bin.empty()) chunks.bin = content;
    at += size;
  }
  // Padding should be spaces; some writers' is zeros.
  while (chunks.json.ends_with('\0')) chunks.json.remove_suffix(1);
  return chunks;
}

void check_version(const Json& root, const GltfJson& json) {
  const auto asset = root.is_object() ? root.find("asset") : root.end();
  if (asset == root.end() || !asset->is_object() ||
      !json.text(*asset, "version").starts_with("2")) {
    json.fail("it is not glTF version 2");
  }
  const std::string least = json.text(*asset, "minVersion");
  if (!least.empty() && least != "2.0") {
    json.fail(fmt::format("it needs glTF version {}, and 2.0 is known here", printable(least)));
  }
}

}  // namespace

bool is_glb(std::string_view bytes) {
  return bytes.starts_with("glTF");
}

bool is_gltf(std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && bytes[start] == '{' &&
         bytes.find("\"asset\"") != std::string_view::npos;
}

SurfaceMesh read_gltf(const MeshSource& source) {
  const std::string& name = source.name;
  const Chunks chunks = split_chunks(source.bytes, name);
  const Json root = parse_json(chunks.json, name);
  check_version(root, GltfJson(name));
  if (chunks.unread > 0) {
    source.warn(fmt::format("{} bytes after the end of the GLB are not read", chunks.unread));
  }
  check_required_extensions(root, name);
  list_pictures(root, source);
  const std::size_t budget = free_elements + 2 * source.bytes.size();
  GltfNodes nodes(root, name);
  GltfAccessors accessors(root, chunks.bin, source.files, budget, name);
  GltfBuilder builder(root, nodes, accessors, source, budget);
  const std::vector<GltfInstance> instances =
      scene_instances(root, nodes, accessors, budget / GltfBuilder::primitive_cost, name);
  ProgressMeter meter(source.context, "load", instances.size(), 1);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    meter.at(i);
    builder.add(instances[i]);
  }
  SurfaceMesh mesh = builder.finish();
  if (source.looks) *source.looks = gltf_looks(root, accessors, source);
  mesh.metres_per_unit = 1;  // section 3.4: all linear distances are in metres
  source.scene = keep_document(root, accessors, builder.take_parts(), mesh, source);
  return mesh;
}

}  // namespace craze
