// What the simulation starts with on its mesh: the recipe's sources, strengths and boundaries.
#pragma once

#include "craze/context.h"
#include "craze/engine/simulation_surface.h"
#include "craze/grey_image.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/simulation_fields.h"
#include "craze/parameters.h"

namespace craze {

/// The picture that `key` names, an empty one where it names none. Throws Error(request) where it
/// was not given.
GreyImage find_texture(const Textures& textures, const std::string& name, const char* key);

/// σ₀, growth, scatter, scales and held vertices of `mesh`, which was made from `surface`. Throws
/// Error(request) where a picture or attribute that the parameters name is missing or does not fit.
SimulationFields initial_fields(const SimulationSurface& surface, const TriangleMesh& mesh,
                                const SimulationParameters& parameters, const Textures& textures,
                                const Context& context);

}  // namespace craze
