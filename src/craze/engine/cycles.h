// evolution.cycles: a layer that cracks, heals and cracks again, as mud that is wetted and dries.
#pragma once

#include <memory>

#include "craze/context.h"
#include "craze/engine/simulation_surface.h"
#include "craze/grey_image.h"
#include "craze/model/simulation.h"

namespace craze {

/// The last cycle of a run. Its cracks are the result, and its load is their time.
struct LastCycle {
  std::unique_ptr<Simulation> simulation;
  StopReason reason = StopReason::max_cracks;
  PhaseTimes times;         ///< of all cycles together, seconds
  bool unstressed = false;  ///< no stress anywhere, now or later: nothing can crack
  bool staggered = false;   ///< places start to be loaded apart from each other
  bool unloaded = false;    ///< no place starts to be loaded before max_load: likewise
  double prepare = 0;       ///< seconds spent on fields and first criteria, of all cycles together
};

/// The first cycle before its first crack.
LastCycle before_first_crack(const SimulationSurface& surface,
                             const SimulationParameters& parameters, const Textures& textures,
                             const Context& context);

/// Cracks `surface` evolution.cycles times. Each cycle starts whole, at load 0, with the noise and
/// scatter of its own seed (the first with that of the recipe), and weakened across the cracks of
/// the cycle before (healed_cracks.h). A cycle that the context cancels or that reaches max_cracks
/// is the last. Wants resolved parameters. Throws Error(request) where the layer has no adhesion
/// and there are several cycles.
LastCycle run_cycles(const SimulationSurface& surface, const SimulationParameters& parameters,
                     const Textures& textures, const Context& context,
                     const OnOpened& on_opened = {});

}  // namespace craze
