// layer.rounds: the spacing asked for, by cracking anew with what was learnt from the last pattern.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "craze/engine/cycles.h"
#include "craze/mesh/components.h"

namespace craze {

/// A run, and what it was made with.
struct SpacedRun {
  Recipe recipe;              ///< its lengths resolved
  SimulationSurface surface;  ///< what the last cycle cracked
  LastCycle last;
  double prepare = 0;  ///< seconds spent on the surface, of all rounds together
  std::vector<SimulationSurface> coarser = {};  ///< for run_cycles; nothing afterwards
};

/// The run before its first crack.
SpacedRun uncracked(SurfaceMesh repaired, const Recipe& recipe, const Textures& textures,
                    const Context& context);

/// Cracks a repaired surface (run_cycles). The screening length that `layer.spacing` stands for is
/// measured on the plane; where fragments bend around what is thinner than they are, the spacing
/// comes out smaller. Up to layer.rounds times more, all is therefore cracked anew with the ℓ at
/// which the rounds so far suggest the right spacing, until mean_spacing is within 5 % of what was
/// asked for. Returns the round that came nearest, with the seconds of all. No more rounds where
/// the spacing is painted, where ℓ was given, and when a run is stopped.
SpacedRun run_to_spacing(SurfaceMesh repaired, const Recipe& recipe, const Textures& textures,
                         const Context& context, const OnOpened& on_opened = {},
                         const Period& period = {});

/// Mean spacing of a pattern, length: √(area / fragments), those at borders included, of which an
/// open surface has few others where the spacing is a good part of its size.
double mean_spacing(const TriangleMesh& cut_mesh, std::int64_t fragments);

/// The same of a pattern on part of a surface, length: of the cut mesh's faces with mask 1 (#F of
/// the mesh before its first cut), √(their area / fragments), a fragment that is only in part made
/// of them counting as that part; 0 where there are none.
double free_spacing(const TriangleMesh& cut_mesh, const Components& fragments,
                    const std::vector<double>& mask);

/// What the report says of a finished run whose spacing is off by over 15 %, and by more than
/// chance does with so many fragments. None where no spacing was asked for or it is painted.
std::optional<std::string> spacing_warning(const LayerParameters& layer,
                                           const TriangleMesh& cut_mesh, std::int64_t fragments);

}  // namespace craze
