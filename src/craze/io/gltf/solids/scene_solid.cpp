#include "craze/io/gltf/solids/scene_solid.h"

#include <string>
#include <utility>
#include <vector>

#include "craze/io/gltf/solids/solid_node.h"

namespace craze {

void add_solid(const SurfaceMesh& solid, Collider collider, std::size_t node, SceneOutput& output) {
  Json& nodes = output.root["nodes"];
  nodes[node]["extras"] = Json(solid_extras(solid, collider));
  const std::string name = collider_name(nodes[node].value("name", std::string()), collider);
  if (name.empty()) return;
  const SurfaceMesh hull = hull_mesh(solid);
  if (hull.triangles.empty()) return;
  GltfElements positions;
  positions.components = 3;
  for (const Vec3& p : hull.positions) positions.append(p.data());
  std::vector<std::uint32_t> indices;
  for (const Triangle& t : hull.triangles) {
    for (const std::int32_t v : t) indices.push_back(static_cast<std::uint32_t>(v));
  }
  const Json bounded{{"min", 0}};
  const std::size_t places = output.add(positions, SceneOutput::Use::vertices, &bounded);
  Json primitive{{"attributes", {{"POSITION", places}}},
                 {"indices", output.add_indices(indices, hull.positions.size(), 0)}};
  Json& meshes = output.root["meshes"];
  Json mesh{{"name", name}, {"primitives", Json::array()}};
  mesh["primitives"].push_back(std::move(primitive));
  nodes[node]["children"].push_back(nodes.size());
  nodes.push_back({{"name", name}, {"mesh", meshes.size()}});
  meshes.push_back(std::move(mesh));
}

}  // namespace craze
