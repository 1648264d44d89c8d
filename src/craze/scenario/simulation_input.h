// From a repaired surface and a recipe to what the simulation starts with.
#pragma once

#include "craze/base/context.h"
#include "craze/mesh/surface_mesh.h"
#include "craze/model/simulation.h"
#include "craze/scenario/recipe.h"

namespace craze {

/// The surface that the simulation runs on, with all attributes of the repaired input.
SurfaceMesh simulation_surface(SurfaceMesh repaired, const Recipe& recipe);

/// σ₀ and whatever else varies over the surface.
SimulationFields simulation_fields(const SurfaceMesh& surface,
                                   const SimulationParameters& parameters, const Context& context);

}  // namespace craze
