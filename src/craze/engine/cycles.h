// evolution.cycles: a layer that cracks, heals and cracks again, as mud that is wetted and dries.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

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
  bool closed = false;      ///< the surface's mask leaves no face that may crack: likewise
  double prepare = 0;       ///< seconds spent on fields and first criteria, of all cycles together
  std::size_t coarser = 0;  ///< 0: it cracked `surface`; i: coarser[i − 1], where it was stopped
};

/// Edges of the coarser meshes for the early ones of so many cycles, over those of the last; none
/// where there are no early ones. They leave scars and nothing else, and junctions forget within
/// about four cycles: the last three crack the surface's own mesh, five before them the first of
/// these, and all earlier ones the second (docs/cycles.md).
std::span<const double> coarser_edges(std::int64_t cycles);

/// Edges of the mesh that the last cycle cracked, over those of the surface's own: 1 unless it was
/// stopped early.
double coarseness(const LastCycle& last, const SimulationParameters& parameters);

/// The first cycle before its first crack.
LastCycle before_first_crack(const SimulationSurface& surface,
                             const SimulationParameters& parameters, const Textures& textures,
                             const Context& context);

/// Cracks `surface` evolution.cycles times. Each cycle starts whole, at load 0, with the noise and
/// scatter of its own seed (the first with that of the recipe), and weakened across the cracks of
/// the cycle before (healed_cracks.h). A cycle that the context cancels or that reaches max_cracks
/// is the last. Wants resolved parameters. Throws Error(request) where the layer has no adhesion
/// and there are several cycles.
/// coarser: the same surface with coarser_edges(), for early cycles; where there are fewer or none,
/// those are cracked on the coarsest there is.
LastCycle run_cycles(const SimulationSurface& surface, const SimulationParameters& parameters,
                     const Textures& textures, const Context& context,
                     const OnOpened& on_opened = {},
                     std::span<const SimulationSurface> coarser = {});

}  // namespace craze
