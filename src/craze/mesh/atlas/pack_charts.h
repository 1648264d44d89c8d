// Charts side by side in the unit square.
#pragma once

#include <vector>

#include "craze/context.h"
#include "craze/mesh/atlas/atlas_charts.h"

namespace craze {

/// Turns and moves the charts, and scales all of them alike, so that their boxes lie in 0 … 1
/// without overlap and with a gap around each: 1/256, or less where there are very many. Throws
/// Cancelled.
void pack_charts(std::vector<AtlasChart>& charts, const Context& context);

}  // namespace craze
