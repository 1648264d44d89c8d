// Lengths with units, and as parts of the object, made numbers in the mesh's own unit.
#pragma once

#include <string>

#include "craze/length.h"
#include "craze/recipe.h"
#include "craze/surface_mesh.h"

namespace craze {

/// What lengths are measured by.
struct Yardstick {
  double diagonal = 0;         ///< of the box around the object, in the mesh's own unit
  double metres_per_unit = 0;  ///< 0: not known
};

/// Those of the mesh's file; where it does not say, those of mesh.unit. 0: not known.
double metres_per_unit(const SurfaceMesh& mesh, const Recipe& recipe);

/// Throws Error(request) where a length of the recipe has a unit of the world and that of the mesh
/// is not known.
void check_units(const Recipe& recipe, double metres_per_unit);

/// A length that is no recipe's, in the mesh's own unit; `name` is its option's. Throws
/// Error(request) where it has a unit of the world and that of the mesh is not known.
double own_length(const Length& length, const Yardstick& yardstick, const std::string& name);

/// The recipe with every length in the mesh's own unit. Throws Error(request) as check_units does,
/// and where a length comes out as a number that its key does not allow.
Recipe with_own_lengths(Recipe recipe, const Yardstick& yardstick);

}  // namespace craze
