#include "craze/products/growth/growth_times.h"

#include "craze/engine/cracked_surface.h"

namespace craze {

GrowthTimes growth_times(const TriangleMesh& mesh, const CrackNetwork& network) {
  GrowthTimes times;
  times.sites = crack_sites(mesh);
  times.schedule = crack_schedule(mesh, times.sites, network);
  return times;
}

GrowthTimes growth_times(const Result& result) {
  return growth_times(result.state().mesh(), result.state().network);
}

}  // namespace craze
