// From a run whose cracks have grown to what products speak of: [post] but for the opening itself.
#pragma once

#include <memory>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"

namespace craze {

/// Puts the cracks into the surface, as rough as `post` says, and reports of it. Of `grown` wants
/// surface, simulation and run; what it has of the rest is replaced. `smooth`: as in
/// SimulationSurface. `post` has its lengths in the mesh's own unit; in the report's recipe
/// relative_roughness and gap_width have become roughness and gap. Throws Cancelled.
Result settle(std::shared_ptr<CrackedSurface> grown, const PostParameters& post,
              const std::vector<Vec3>& smooth, const Context& context);

}  // namespace craze
