// Every place of a glTF document where an accessor is named.
#pragma once

#include <string>

#include "craze/io/gltf/gltf_json.h"

namespace craze {

/// Calls visit(number) for each: attributes, targets and indices of primitives, samplers of
/// animations, skins, instances of nodes. Extensions' own places are not known.
template <class Visit>
void for_each_accessor_place(Json& root, Visit&& visit) {
  const auto each = [](Json& object, const char* list, auto&& take) {
    const auto found = object.is_object() ? object.find(list) : object.end();
    if (found == object.end() || !found->is_array()) return;
    for (Json& item : *found) take(item);
  };
  const auto named = [&](Json& object, const char* key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (found != object.end() && found->is_number()) visit(*found);
  };
  const auto all_of = [&](Json& object) {
    if (!object.is_object()) return;
    for (Json& value : object) {
      if (value.is_number()) visit(value);
    }
  };
  each(root, "meshes", [&](Json& mesh) {
    each(mesh, "primitives", [&](Json& primitive) {
      named(primitive, "indices");
      if (primitive.is_object() && primitive.contains("attributes")) {
        all_of(primitive["attributes"]);
      }
      each(primitive, "targets", all_of);
    });
  });
  each(root, "skins", [&](Json& skin) { named(skin, "inverseBindMatrices"); });
  each(root, "animations", [&](Json& animation) {
    each(animation, "samplers", [&](Json& sampler) {
      named(sampler, "input");
      named(sampler, "output");
    });
  });
  const Json::json_pointer instances("/extensions/EXT_mesh_gpu_instancing/attributes");
  each(root, "nodes", [&](Json& node) {
    if (node.contains(instances)) all_of(node[instances]);
  });
}

/// Calls visit(number) wherever anything, extensions included, names a view.
template <class Visit>
void for_each_view_place(Json& json, Visit&& visit) {
  if (json.is_object()) {
    for (auto& [key, value] : json.items()) {
      if (key == "bufferView" && value.is_number()) {
        visit(value);
      } else {
        for_each_view_place(value, visit);
      }
    }
  } else if (json.is_array()) {
    for (Json& value : json) for_each_view_place(value, visit);
  }
}

}  // namespace craze
