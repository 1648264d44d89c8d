#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/io/gltf/gltf_primitive.h"

#include <algorithm>
#include <set>

namespace craze {

namespace {

/// The names of the objects in one of the document's lists.
SceneContent named(const Json& root, const char* list, const char* kind) {
  SceneContent content{kind, {}};
  const auto found = root.find(list);
  if (found == root.end() || !found->is_array()) return content;
  for (const Json& item : *found) {
    const bool has_name = item.is_object() && item.contains("name") && item["name"].is_string();
    content.names.push_back(has_name ? item["name"].get<std::string>() : std::string());
  }
  return content;
}

/// What vertices have besides what a plain mesh holds.
struct VertexData {
  std::set<std::string> uv_sets, others, targets;
  std::vector<std::string> loose;  ///< one for each primitive of points or lines,
  std::vector<std::string> bands;  ///< and of triangles that draw cracks
};

VertexData vertex_data(const Json& root) {
  VertexData data;
  const auto each_key = [](const Json& object, auto&& take) {
    if (!object.is_object()) return;
    for (const auto& [key, value] : object.items()) take(key);
  };
  if (!root.contains("meshes")) return data;
  for (const Json& mesh : root["meshes"]) {
    if (!mesh.contains("primitives")) continue;
    for (const Json& primitive : mesh["primitives"]) {
      if (!primitive.contains("attributes")) continue;
      const auto mode = primitive.find("mode");
      const bool is_open = mode != primitive.end() && mode->is_number() && mode->get<double>() < 4;
      if (is_open || draws_cracks(primitive)) {
        (is_open ? data.loose : data.bands).push_back(mesh.value("name", ""));
      }
      each_key(primitive["attributes"], [&](const std::string& key) {
        if (key.starts_with("TEXCOORD_") && key != "TEXCOORD_0") data.uv_sets.insert(key);
        const bool further_color = key.starts_with("COLOR_") && key != "COLOR_0";
        if (key == "TANGENT" || further_color) data.others.insert(key);
      });
      if (!primitive.contains("targets")) continue;
      for (std::size_t t = 0; t < primitive["targets"].size(); ++t) {
        data.targets.insert(std::to_string(t));
      }
    }
  }
  return data;
}

/// Lights and whatever else extensions bring to the document.
SceneContent lights(const Json& root) {
  const Json::json_pointer at("/extensions/KHR_lights_punctual");
  return root.contains(at) ? named(root[at], "lights", "lights") : SceneContent{"lights", {}};
}

/// What objects of the document carry that glTF has no key of its own for.
class Annotations {
 public:
  /// `of`: behind the kinds' names, such as " of meshes".
  explicit Annotations(const std::string& of)
      : extensions_{"extensions" + of, {}, true}, extras_{"extras" + of, {}} {}

  void take(const Json& object) {
    if (!object.is_object()) return;
    if (const auto own = object.find("extensions"); own != object.end() && own->is_object()) {
      for (const auto& [name, value] : own->items()) {
        // Lights are listed, and copies are part of the surface.
        if (name != "KHR_lights_punctual" && name != "EXT_mesh_gpu_instancing") names_.insert(name);
      }
    }
    if (!object.contains("extras")) return;
    Json extras = object["extras"];
    if (extras.is_object()) extras.erase("targetNames");  // of morph targets, which are listed
    if (!extras.empty()) extras_.names.emplace_back();
  }
  void take_all(const Json& object, const char* list) {
    if (!object.is_object() || !object.contains(list)) return;
    for (const Json& item : object[list]) take(item);
  }
  void add_to(std::vector<SceneContent>& contents) {
    extensions_.names.assign(names_.begin(), names_.end());
    contents.push_back(extensions_);
    contents.push_back(extras_);
  }

 private:
  SceneContent extensions_, extras_;
  std::set<std::string> names_;
};

void add_annotations(const Json& root, std::vector<SceneContent>& contents) {
  SceneContent copyright{"copyright", {}, true};
  Annotations of_document(""), of_meshes(" of meshes");
  of_document.take(root);
  if (const auto asset = root.find("asset"); asset != root.end() && asset->is_object()) {
    const auto text = asset->find("copyright");
    if (text != asset->end() && text->is_string()) copyright.names.push_back(*text);
    of_document.take(*asset);
  }
  of_document.take_all(root, "scenes");
  of_document.take_all(root, "nodes");
  of_meshes.take_all(root, "meshes");
  if (root.contains("meshes")) {
    for (const Json& mesh : root["meshes"]) of_meshes.take_all(mesh, "primitives");
  }
  contents.push_back(copyright);
  of_document.add_to(contents);
  of_meshes.add_to(contents);
}

}  // namespace

GltfDocument::GltfDocument(Json root, std::string bin, std::vector<GltfPart> parts,
                           const SurfaceMesh& mesh)
    : root_(std::move(root)),
      bin_(std::move(bin)),
      parts_(std::move(parts)),
      triangles_(mesh.triangles),
      positions_(mesh.positions),
      objects_(mesh.object_names) {
  for (const Attribute& a : mesh.vertex_attributes) attributes_.push_back(a.name);
}

std::size_t GltfDocument::part_of(std::int32_t face) const {
  const auto after =
      std::upper_bound(parts_.begin(), parts_.end(), face,
                       [](std::int32_t f, const GltfPart& part) { return f < part.first_face; });
  return static_cast<std::size_t>(after - parts_.begin()) - 1;
}

int GltfDocument::color_bits() const {
  int bits = 0;
  const GltfJson json(document_name);
  for (const Json& mesh : json.array(root_, "meshes")) {
    for (const Json& primitive : json.array(mesh, "primitives")) {
      const auto attributes = primitive.find("attributes");
      if (attributes == primitive.end() || !attributes->is_object()) continue;
      const auto accessor = json.index(*attributes, "COLOR_0");
      if (!accessor) continue;
      const std::size_t type =
          json.index_or(json.item(root_, "accessors", *accessor), "componentType", 0);
      bits = std::max(bits, 8 * static_cast<int>(component_size(type)));
    }
  }
  return bits;
}

std::vector<OtherName> GltfDocument::other_names() const {
  const GltfJson json(document_name);
  const Json& nodes = json.array(root_, "nodes");
  std::vector<std::size_t> parent(nodes.size(), nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (const Json& child : json.array(nodes[n], "children")) {
      const std::size_t c = json.as_index(child, "children");
      if (c < nodes.size()) parent[c] = n;
    }
  }
  std::vector<OtherName> names;
  std::set<std::int32_t> seen;
  for (const GltfPart& part : parts_) {
    const auto object = static_cast<std::size_t>(part.object);
    if (object >= objects_.size() || !seen.insert(part.object).second) continue;
    const auto add = [&](const Json& named) {
      const std::string name = json.text(named, "name");
      if (!name.empty()) names.push_back({name, objects_[object]});
    };
    add(json.item(root_, "meshes", part.mesh));
    std::size_t left = nodes.size();  // a ring is no tree
    for (std::size_t n = part.node; n < nodes.size() && left > 0; n = parent[n], --left) {
      add(nodes[n]);
    }
  }
  return names;
}

std::vector<SceneContent> GltfDocument::contents() const {
  const VertexData vertices = vertex_data(root_);
  const auto listed = [](const char* kind, const std::set<std::string>& names) {
    return SceneContent{kind, {names.begin(), names.end()}};
  };
  std::vector<SceneContent> all = {
      named(root_, "nodes", "nodes"),
      named(root_, "meshes", "meshes"),
      named(root_, "materials", "materials"),
      named(root_, "textures", "textures"),
      named(root_, "images", "images"),
      named(root_, "animations", "animations"),
      named(root_, "skins", "skins"),
      named(root_, "cameras", "cameras"),
      lights(root_),
      listed("further UV sets", vertices.uv_sets),
      listed("vertex attributes of its own", vertices.others),
      listed("morph targets", vertices.targets),
      {"primitives of points or lines", vertices.loose},
      {"crack lines as bands of triangles", vertices.bands},
  };
  add_annotations(root_, all);
  std::erase_if(all, [](const SceneContent& content) { return content.names.empty(); });
  return all;
}

}  // namespace craze
