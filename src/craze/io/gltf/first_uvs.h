// Materials for vertices that have one set of UVs.
#pragma once

#include <string>
#include <vector>

namespace craze {

/// Takes out of materials, JSON of any kind, textures that ask for a UV set beyond the first.
template <class AnyJson>
void keep_first_uvs(AnyJson& json) {
  if (json.is_array()) {
    for (AnyJson& item : json) keep_first_uvs(item);
  }
  if (!json.is_object()) return;
  std::vector<std::string> gone;
  for (auto& [key, value] : json.items()) {
    if (value.is_object() && value.contains("index") && value.value("texCoord", 0) > 0) {
      gone.push_back(key);
    } else {
      keep_first_uvs(value);
    }
  }
  for (const std::string& key : gone) json.erase(key);
}

}  // namespace craze
