// Nodes by the names that a file gives them in other ways.
#pragma once

#include <string>
#include <vector>

#include "craze/recipe.h"
#include "craze/surface_mesh.h"

namespace craze {

class SourceScene;  // read_mesh.h

/// The recipe with names in where.nodes that stand for several nodes of the surface spelt out: a
/// node's for all below it, a mesh's, an OBJ file's `o` or `g` alone. Patterns that fit nodes
/// themselves, and those that fit nothing, stay. scene: what the surface was read with; may be
/// null.
Recipe with_named_nodes(Recipe recipe, const SurfaceMesh& surface, const SourceScene* scene);

}  // namespace craze
