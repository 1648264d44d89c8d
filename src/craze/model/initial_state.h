// Step 1 of the paper's loop: the mesh under its first stress, and what will load it.
#pragma once

#include "craze/context.h"
#include "craze/model/cracked_sheet.h"
#include "craze/model/relaxation/loading.h"
#include "craze/model/simulation_fields.h"
#include "craze/parameters.h"

namespace craze {

/// The same parameters. Throws Error(request) where one is out of the range that can be computed
/// with.
SimulationParameters checked(const SimulationParameters& parameters);

/// The mesh under σ₀, or unstressed where places start apart, with its held and pinned nodes.
/// Throws Error(request) where a field's size is wrong or a stress out of range, and Cancelled.
CrackedSheet stressed_sheet(TriangleMesh mesh, const SimulationFields& fields, Engine engine,
                            const Context& context);

/// What the loading needs of the fields, which is taken from them.
InitialLoad initial_load(const CrackedSheet& sheet, SimulationFields& fields,
                         const MaterialParameters& material);

}  // namespace craze
