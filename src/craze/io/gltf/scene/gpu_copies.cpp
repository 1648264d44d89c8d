// Format: EXT_mesh_gpu_instancing.
#include "craze/io/gltf/scene/gpu_copies.h"

#include <algorithm>
#include <map>
#include <string>

#include "craze/base/elementary.h"

namespace craze {

namespace {

constexpr const char* instancing = "EXT_mesh_gpu_instancing";

Json numbers(const GltfElements& elements, std::size_t i) {
  Json list = Json::array();
  for (std::size_t k = 0; k < elements.components; ++k) list.push_back(elements.value(i, k));
  return list;
}

/// A quaternion of length 1, as a node's must be.
Json unit(const Json& rotation) {
  double length = 0;
  for (const Json& x : rotation) length = elementary::hypot(length, x.get<double>());
  if (!(length > 0)) return {0, 0, 0, 1};
  Json result = Json::array();
  for (const Json& x : rotation) result.push_back(x.get<double>() / length);
  return result;
}

bool shows_copies(const Json& nodes) {
  return std::any_of(nodes.begin(), nodes.end(), [](const Json& node) {
    return node.contains("extensions") && node["extensions"].contains(instancing);
  });
}

}  // namespace

SeparatedCopies separate_copies(const Json& document, std::size_t node,
                                const std::vector<std::size_t>& copies, GltfAccessors& accessors,
                                SceneOutput& output) {
  const Json& old = document["nodes"][node];
  std::map<std::string, GltfElements> attributes;
  std::size_t count = 0;
  for (const auto& [name, accessor] : old["extensions"][instancing]["attributes"].items()) {
    const auto read = attributes.emplace(name, accessors.elements(accessor)).first;
    count = read->second.count;
  }
  SeparatedCopies separated;
  Json& nodes = output.root["nodes"];
  Json children = old.contains("children") ? old["children"] : Json::array();
  for (const std::size_t copy : copies) {
    Json child = Json::object();
    if (old.contains("name")) {
      child["name"] = old["name"].get<std::string>() + "_" + std::to_string(copy);
    }
    if (old.contains("weights")) child["weights"] = old["weights"];
    for (const auto& [name, elements] : attributes) {
      if (name == "TRANSLATION") child["translation"] = numbers(elements, copy);
      if (name == "ROTATION") child["rotation"] = unit(numbers(elements, copy));
      if (name == "SCALE") child["scale"] = numbers(elements, copy);
    }
    children.push_back(nodes.size());
    separated.nodes.push_back(nodes.size());
    nodes.push_back(std::move(child));
  }
  Json& parent = nodes[node];
  parent["children"] = std::move(children);
  separated.any_left = copies.size() < count;
  if (!separated.any_left) {
    for (const char* key : {"mesh", "weights"}) parent.erase(key);
    parent["extensions"].erase(instancing);
    if (parent["extensions"].empty()) parent.erase("extensions");
    if (!shows_copies(nodes)) output.forget_extension(instancing);
    return separated;
  }
  Json& left = parent["extensions"][instancing]["attributes"];
  for (const auto& [name, elements] : attributes) {
    GltfElements others = elements;
    others.bytes.clear();
    others.count = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (std::binary_search(copies.begin(), copies.end(), i)) continue;
      others.bytes += elements.bytes.substr(i * elements.size(), elements.size());
      ++others.count;
    }
    left[name] = output.add(others, SceneOutput::Use::plain,
                            &output.accessor(left[name].get<std::size_t>()));
  }
  return separated;
}

}  // namespace craze
