#include <algorithm>

#include "craze/io/gltf/glb_mesh.h"
#include "craze/io/gltf/scene/loose_primitive.h"
#include "craze/io/gltf/scene/scene_growth.h"
#include "craze/mesh/run_attributes.h"

namespace craze {

Json wall_primitive(const PrimitiveSource& source, const std::vector<std::int32_t>& walls,
                    std::size_t material, const SceneGrowth* growth, SceneOutput& output) {
  LoosePrimitive made(source, walls, LoosePrimitive::Kind::walls, false);
  if (growth) made.add_targets(*growth);
  Json json = made.write(output);
  json["material"] = material;
  return json;
}

void add_crack_attributes(const CutScene& cut, const std::vector<std::int32_t>& owner,
                          PrimitiveVertices& vertices) {
  const std::vector<std::string>& known = cut.document().attributes();
  for (const Attribute& a : cut.mesh().vertex_attributes) {
    const bool is_old = std::find(known.begin(), known.end(), a.name) != known.end();
    if (is_old && !is_run_attribute(a.name)) continue;
    for (const GlbColumns& columns : glb_columns(a)) {
      GltfElements elements;
      elements.components = static_cast<std::size_t>(columns.components);
      constexpr double nowhere[] = {-1, -1, -1, -1};
      for (const std::int32_t v : owner) {
        elements.append(
            v < 0 ? nowhere
                  : &a.values[static_cast<std::size_t>(v) * static_cast<std::size_t>(a.components) +
                              static_cast<std::size_t>(columns.first)]);
      }
      vertices.set(columns.name, std::move(elements));
    }
  }
}

void forget_form(Json& primitive) {
  primitive.erase("mode");
  if (!primitive.contains("extensions")) return;
  primitive["extensions"].erase("KHR_draco_mesh_compression");
  if (primitive["extensions"].empty()) primitive.erase("extensions");
}

}  // namespace craze
