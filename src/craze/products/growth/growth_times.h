// When each crack of a run opens: what everything that shows growth starts from.
#pragma once

#include "craze/engine.h"
#include "craze/products/growth/crack_schedule.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

struct GrowthTimes {
  CrackSites sites;        ///< both sides of each crack together
  CrackSchedule schedule;  ///< when the cracks come to them
};

/// `network` is that of the mesh.
GrowthTimes growth_times(const TriangleMesh& mesh, const CrackNetwork& network);
GrowthTimes growth_times(const Result& result);

}  // namespace craze
