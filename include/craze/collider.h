// How files give the shapes that physics engines let solids collide with.
#pragma once

namespace craze {

/// The convex hull of a solid, in GLB.
enum class Collider {
  none,    ///< not at all
  extras,  ///< as numbers in its node's extras
  unreal,  ///< as a node UCX_NAME below its own, which Unreal's importer takes for a collider
  godot,   ///< as a node NAME-convcolonly below its own, which Godot's importer takes for one
};

}  // namespace craze
