#include "craze/products/growth/growth_times.h"

#include "craze/engine/cracked_surface.h"

namespace craze {

GrowthTimes growth_times(const Result& result) {
  const CrackedSurface& state = result.state();
  GrowthTimes times;
  times.sites = crack_sites(state.simulation->mesh());
  times.schedule = crack_schedule(state.simulation->mesh(), times.sites, state.network);
  return times;
}

}  // namespace craze
