#include "craze/io/gltf/scene/scene_materials.h"

#include <algorithm>
#include <string>

#include "craze/io/gltf/scene/scene_output.h"

namespace craze {

namespace {

Json& materials_of(Json& root) {
  if (!root.contains("materials")) root["materials"] = Json::array();
  return root["materials"];
}

std::string free_name(const Json& materials, const std::string& wanted) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(materials.begin(), materials.end(), [&](const Json& material) {
      const auto found = material.find("name");
      return found != material.end() && found->is_string() &&
             found->get_ref<const std::string&>() == name;
    });
  };
  std::string name = wanted;
  for (int n = 2; is_taken(name); ++n) name = wanted + "_" + std::to_string(n);
  return name;
}

Json matt(const std::string& name, double grey) {
  return {{"name", name},
          {"doubleSided", true},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {grey, grey, grey, 1.0}},
            {"metallicFactor", 0.0},
            {"roughnessFactor", 0.8}}}};
}

}  // namespace

std::size_t add_wall_material(SceneOutput& output) {
  constexpr double grey = 0.25;
  Json& materials = materials_of(output.root);
  materials.push_back(matt(free_name(materials, "crack_wall"), grey));
  return materials.size() - 1;
}

std::size_t add_line_material(SceneOutput& output) {
  constexpr double grey = 0.02;
  Json& materials = materials_of(output.root);
  Json material = matt(free_name(materials, "crack_line"), grey);
  material["extensions"]["KHR_materials_unlit"] = Json::object();
  materials.push_back(std::move(material));
  output.use_extension("KHR_materials_unlit");
  return materials.size() - 1;
}

}  // namespace craze
