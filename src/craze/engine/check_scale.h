// Requests whose scale does not fit the object or the machine, found before any work.
#pragma once

#include "craze/base/period.h"
#include "craze/recipe.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Bytes of main memory of this machine; infinity where it is not known.
double physical_memory();

/// Throws Error(request) naming the key, the numbers and what would do: a spacing or edge larger
/// than the object, or an edge length (the one that remeshing aims for; 0: none) whose triangles
/// would need more than `memory` bytes. Lengths in the recipe are resolved (screening.h).
void check_scale(const SurfaceMesh& surface, const Recipe& recipe, double target_edge,
                 double memory, const Period& period = {});

}  // namespace craze
