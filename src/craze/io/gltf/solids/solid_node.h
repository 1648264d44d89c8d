// What the node of a solid says of it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "craze/collider.h"
#include "craze/mesh/convex_hull.h"
#include "craze/mesh/mass_properties.h"
#include "craze/surface_mesh.h"

namespace craze {

/// As mass_properties() has them, of a solid that may be mirrored: its volume is not below 0.
MassProperties solid_mass(const SurfaceMesh& solid);

/// `solid` is placed about its node's origin. "volume"; "center_of_mass", 3 numbers; "inertia", 9
/// numbers row by row, about that centre along the node's axes, density 1; for Collider::extras
/// "collider", its convex hull: "positions", 3 numbers a vertex, and "triangles", 3 vertices each.
nlohmann::ordered_json solid_extras(const SurfaceMesh& solid, Collider collider);

/// The name of the node that has the hull of the node `name`; empty where none is to be had.
std::string collider_name(const std::string& name, Collider collider);

/// Without anything but positions; without triangles where the solid is flat.
SurfaceMesh hull_mesh(const SurfaceMesh& solid);

}  // namespace craze
