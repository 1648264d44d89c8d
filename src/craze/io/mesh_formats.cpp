#include "craze/io/mesh_formats.h"

#include <algorithm>

#include "craze/io/gltf/gltf.h"
#include "craze/io/obj/obj.h"
#include "craze/io/off/off.h"
#include "craze/io/ply/ply.h"
#include "craze/io/stl/stl.h"
#include "craze/io/usd/usd.h"

namespace craze {

std::span<const MeshFormat> mesh_formats() {
  static constexpr MeshFormat all[] = {
      {"obj", nullptr, read_obj, write_obj, true, false},
      {"ply", is_ply, read_ply, write_ply, false, false},
      {"stl", is_stl, read_stl, write_stl, false, false},
      {"off", is_off, read_off, nullptr, false, false},
      {"gltf", is_gltf, read_gltf, nullptr, false, false},
      {"glb", is_glb, read_gltf, write_glb, true, true},
      {"usda", nullptr, nullptr, write_usda, true, true},
  };
  return all;
}

const MeshFormat* find_mesh_format(std::string_view name) {
  if (name.starts_with('.')) name.remove_prefix(1);
  const auto equal = [](char a, char lower) {
    return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == lower;
  };
  for (const MeshFormat& format : mesh_formats()) {
    if (std::equal(name.begin(), name.end(), format.name.begin(), format.name.end(), equal)) {
      return &format;
    }
  }
  return nullptr;
}

}  // namespace craze
