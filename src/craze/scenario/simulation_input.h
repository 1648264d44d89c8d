// From a repaired surface and a recipe to what the simulation starts with.
#pragma once

#include "craze/base/context.h"
#include "craze/mesh/surface_mesh.h"
#include "craze/model/simulation.h"
#include "craze/scenario/recipe.h"

namespace craze {

/// The surface that the simulation runs on, with every attribute of the repaired input. mesh.edge
/// "keep": the input itself. A length: remeshed to it. "auto": remeshed to a quarter of the
/// screening length where the input's edges are longer than that on average, else the input itself.
SurfaceMesh simulation_surface(SurfaceMesh repaired, const Recipe& recipe, const Context& context);

/// σ₀, growth, scatter, scales and held vertices of `mesh`, which was made from `surface`. Pictures
/// are read from the files that the recipe names. Throws Error where a picture or attribute is
/// missing or does not fit.
SimulationFields simulation_fields(const SurfaceMesh& surface, const TriangleMesh& mesh,
                                   const SimulationParameters& parameters, const Context& context);

}  // namespace craze
