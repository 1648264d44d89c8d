// What a recipe can name of a mesh, and a spacing to begin with.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "craze/surface_mesh.h"

namespace craze::app {

/// Lines of text: unit and size, materials, nodes, UV sets, a spacing and commands to try. `file`
/// is what the mesh was read from, `size` its box's, `diagonal` that box's; in the mesh's own unit.
std::string asset_text(const std::string& file, const SurfaceMesh& mesh, const Vec3& size,
                       double diagonal);

/// The same as members of an object: metres_per_unit (null: not known), materials and nodes
/// (name, triangles), uv_sets, suggested_spacing.
nlohmann::ordered_json asset_json(const SurfaceMesh& mesh, double diagonal);

}  // namespace craze::app
