// The state that a run ends in: what every product is made from.
#pragma once

#include <memory>

#include "craze/engine/simulation_surface.h"
#include "craze/mesh/components.h"
#include "craze/model/crack_network.h"
#include "craze/model/simulation.h"
#include "craze/recipe.h"

namespace craze {

struct CrackedSurface {
  Recipe recipe;                                 ///< as it was run: lengths resolved
  SurfaceMesh surface;                           ///< the simulation's mesh before its first crack
  std::unique_ptr<const Simulation> simulation;  ///< stopped: the cut mesh, its stress, its times
  CrackNetwork network;                          ///< the cracks of that mesh
  Components fragments;                          ///< the parts of that mesh
};

}  // namespace craze
