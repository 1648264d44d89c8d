// Format: Khronos Group, "glTF 2.0 Specification", 2021, sections 3.6.1 and 3.8.

#include <cmath>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/bytes/data_uri.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/files/sibling_files.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/io/image/picture_fault.h"
#include "craze/io/image/picture_type.h"

namespace craze {

namespace {

void pad(std::string& bytes) {
  bytes.resize(aligned(bytes.size()), '\0');
}

/// "clay" for "textures/clay.png".
std::string stem(const std::string& uri) {
  const std::size_t slash = uri.find_last_of('/');
  const std::string name = slash == std::string::npos ? uri : uri.substr(slash + 1);
  return name.substr(0, name.find_last_of('.'));
}

/// Moves all that the document refers to into one buffer.
class Gatherer {
 public:
  Gatherer(Json& root, GltfAccessors& accessors, const MeshSource& source)
      : root_(root), accessors_(accessors), source_(source), json_(source.name) {}

  std::string run() {
    std::vector<std::size_t> begins;
    for (std::size_t b = 0; b < json_.array(root_, "buffers").size(); ++b) {
      pad(bin_);
      begins.push_back(bin_.size());
      bin_ += accessors_.buffer(b);
    }
    for (std::size_t v = 0; v < json_.array(root_, "bufferViews").size(); ++v) move_view(v, begins);
    for (const auto& [accessor, instead] : accessors_.broken()) mend(accessor, instead);
    for (std::size_t i = 0; i < json_.array(root_, "images").size(); ++i) move_picture(i);
    if (bin_.empty()) return bin_;
    // What one buffer says of itself stays; of several nothing can.
    Json buffer = begins.size() == 1 ? root_["buffers"][0] : Json::object();
    buffer.erase("uri");
    buffer["byteLength"] = bin_.size();
    root_["buffers"] = Json::array({std::move(buffer)});
    return std::move(bin_);
  }

 private:
  /// Puts `instead` for the numbers of an accessor that are not finite, its sparse ones too.
  void mend(std::size_t accessor, double instead) {
    const Json json = json_.item(root_, "accessors", accessor);
    const std::size_t floats = accessors_.elements(accessor).components;
    mend_floats(json, json_.index_or(json, "count", 0), floats, instead);
    const Json::json_pointer values("/sparse/values"), count("/sparse/count");
    if (json.contains(values) && json.contains(count)) {
      mend_floats(json[values], json_.as_index(json[count], "count"), floats, instead);
    }
  }

  void mend_floats(const Json& place, std::size_t count, std::size_t floats, double instead) {
    const auto number = json_.index(place, "bufferView");
    if (!number) return;
    const Json& view = json_.item(root_, "bufferViews", *number);
    const std::size_t size = floats * sizeof(float),
                      stride = json_.index_or(view, "byteStride", size),
                      begin = json_.index_or(view, "byteOffset", 0) +
                              json_.index_or(place, "byteOffset", 0);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < floats; ++k) {
        char* const at = bin_.data() + begin + i * stride + k * sizeof(float);
        if (!std::isfinite(load<float>(at))) store(at, static_cast<float>(instead));
      }
    }
  }

  void move_view(std::size_t v, const std::vector<std::size_t>& begins) {
    json_.item(root_, "bufferViews", v);
    Json& view = root_["bufferViews"][v];
    const auto buffer = json_.index(view, "buffer");
    if (!buffer || *buffer >= begins.size()) json_.fail("a bufferView has no buffer");
    const std::size_t offset = json_.index_or(view, "byteOffset", 0) + begins[*buffer];
    view["buffer"] = 0;
    if (offset > 0) view["byteOffset"] = offset;
    // The plain bytes stand beside the compressed ones, or the file would have been refused.
    for (const char* meshopt : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
      if (!json_.extension(view, meshopt)) continue;
      view["extensions"].erase(meshopt);
      if (view["extensions"].empty()) view.erase("extensions");
    }
  }

  void move_picture(std::size_t i) {
    json_.item(root_, "images", i);
    Json& image = root_["images"][i];
    const std::string uri = json_.text(image, "uri");
    if (uri.empty()) return look_at_held(i);
    const bool inside = is_data_uri(uri);
    std::string_view bytes;
    try {
      bytes = accessors_.source(uri);
    } catch (const Error&) {
      source_.warn(
          fmt::format("picture '{}' cannot be brought; it stays named, not held", printable(uri)));
      return;
    }
    std::string type = picture_type(bytes);
    if (type.empty() && inside) type = std::string(data_uri_type(uri));
    if (type.empty()) return;
    warn_of_fault(i, bytes);
    pad(bin_);
    image.erase("uri");
    image["mimeType"] = type;
    image["bufferView"] = json_.array(root_, "bufferViews").size();
    if (!inside && !image.contains("name")) image["name"] = stem(decode_percent(uri));
    root_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bin_.size()}, {"byteLength", bytes.size()}});
    bin_ += bytes;
  }

  /// A picture that has come with a buffer.
  void look_at_held(std::size_t i) const {
    const auto number = json_.index(root_["images"][i], "bufferView");
    if (!number) return;
    std::string_view bytes;
    const Json& views = json_.array(root_, "bufferViews");
    if (*number < views.size()) {
      const std::size_t begin = json_.index_or(views[*number], "byteOffset", 0),
                        length = json_.index_or(views[*number], "byteLength", 0);
      if (begin <= bin_.size()) bytes = std::string_view(bin_).substr(begin, length);
    }
    warn_of_fault(i, bytes);
  }

  void warn_of_fault(std::size_t i, std::string_view bytes) const {
    const std::string fault = picture_fault(bytes);
    // Extensions bring kinds of their own, which they name.
    const std::string type = json_.text(root_["images"][i], "mimeType");
    const bool is_other = !type.empty() && type != "image/png" && type != "image/jpeg";
    if (fault.empty() || (is_other && picture_type(bytes).empty())) return;
    const std::string name = json_.text(root_["images"][i], "name");
    source_.warn(fmt::format("image {}{} is broken, and is handed on as it is: {}", i,
                             name.empty() ? "" : " '" + printable(name) + "'", fault));
  }

  Json& root_;
  GltfAccessors& accessors_;
  const MeshSource& source_;
  GltfJson json_;
  std::string bin_;
};

/// What readers pass over and writers rely on: lists of objects, names that are text, views with a
/// size, channels with a target. Throws Error(input).
void check_lists(const Json& root, const GltfJson& json) {
  for (const char* list : {"nodes", "meshes", "accessors", "bufferViews", "materials", "textures",
                           "images", "samplers", "skins", "animations", "cameras", "scenes"}) {
    const Json& items = json.array(root, list);
    for (std::size_t i = 0; i < items.size(); ++i) {
      const Json& item = json.item(root, list, i);
      if (item.contains("name") && !item["name"].is_string()) {
        json.fail(fmt::format("the name of '{}' item {} is not text", list, i));
      }
      for (const char* index : {"mesh", "skin", "byteLength", "byteOffset", "bufferView"}) {
        static_cast<void>(json.index(item, index));
      }
    }
  }
  for (const Json& view : json.array(root, "bufferViews")) {
    if (!view.contains("byteLength")) json.fail("a bufferView has no byteLength");
  }
  for (const Json& animation : json.array(root, "animations")) {
    for (const Json& channel : json.array(animation, "channels")) {
      if (!channel.is_object() || !channel.contains("target") || !channel["target"].is_object()) {
        json.fail("a channel of an animation has no target");
      }
    }
  }
  for (const Json& mesh : json.array(root, "meshes")) {
    for (const Json& primitive : json.array(mesh, "primitives")) {
      if (!primitive.is_object()) json.fail("a primitive is not an object");
    }
  }
}

/// A file without nodes shows nothing elsewhere; here it shows each mesh.
void give_nodes(Json& root) {
  if (root.contains("nodes")) return;
  Json nodes = Json::array(), all = Json::array();
  for (std::size_t m = 0; m < root["meshes"].size(); ++m) {
    nodes.push_back({{"mesh", m}});
    all.push_back(m);
  }
  root["nodes"] = std::move(nodes);
  root["scenes"] = Json::array({{{"nodes", std::move(all)}}});
  root["scene"] = 0;
}

}  // namespace

std::shared_ptr<const GltfDocument> keep_document(Json root, GltfAccessors& accessors,
                                                  std::vector<GltfPart> parts,
                                                  const SurfaceMesh& mesh,
                                                  const MeshSource& source) {
  try {
    check_lists(root, GltfJson(source.name));
    std::string bin = Gatherer(root, accessors, source).run();
    give_nodes(root);
    return std::make_shared<const GltfDocument>(std::move(root), std::move(bin), std::move(parts),
                                                mesh);
  } catch (const Error& error) {
    source.warn(fmt::format("the scene is not kept, only its surface: {}", error.what()));
  } catch (const Json::exception&) {
    source.warn("the scene is not kept, only its surface: its JSON is not as glTF wants it");
  }
  return nullptr;
}

}  // namespace craze
