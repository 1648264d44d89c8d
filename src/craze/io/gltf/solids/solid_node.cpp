#include "craze/io/gltf/solids/solid_node.h"

namespace craze {

MassProperties solid_mass(const SurfaceMesh& solid) {
  MassProperties mass = mass_properties(solid.positions, solid.triangles);
  if (mass.volume < 0) {
    mass.volume = -mass.volume;
    mass.inertia = -mass.inertia;
  }
  return mass;
}

nlohmann::ordered_json solid_extras(const SurfaceMesh& solid, Collider collider) {
  const MassProperties mass = solid_mass(solid);
  nlohmann::ordered_json extras;
  extras["volume"] = mass.volume;
  extras["center_of_mass"] = {mass.centre.x(), mass.centre.y(), mass.centre.z()};
  nlohmann::ordered_json& inertia = extras["inertia"] = nlohmann::ordered_json::array();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) inertia.push_back(mass.inertia(i, j));
  }
  if (collider != Collider::extras) return extras;
  const ConvexHull hull = convex_hull(solid.positions);
  nlohmann::ordered_json positions = nlohmann::ordered_json::array(), triangles = positions;
  for (const Vec3& p : hull.positions) {
    for (const double x : p) positions.push_back(static_cast<float>(x));
  }
  for (const Triangle& t : hull.triangles) {
    for (const std::int32_t v : t) triangles.push_back(v);
  }
  extras["collider"]["positions"] = std::move(positions);
  extras["collider"]["triangles"] = std::move(triangles);
  return extras;
}

std::string collider_name(const std::string& name, Collider collider) {
  if (collider == Collider::unreal) return "UCX_" + name;
  if (collider == Collider::godot) return name + "-convcolonly";
  return {};
}

SurfaceMesh hull_mesh(const SurfaceMesh& solid) {
  ConvexHull hull = convex_hull(solid.positions);
  SurfaceMesh mesh;
  mesh.positions = std::move(hull.positions);
  mesh.triangles = std::move(hull.triangles);
  return mesh;
}

}  // namespace craze
