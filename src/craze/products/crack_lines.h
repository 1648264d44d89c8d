// The cracks of a run as lines.
#pragma once

#include "craze/engine.h"
#include "craze/line_set.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Point attributes: junction (JunctionKind as a number), nx ny nz. Edge attributes: time, width,
/// event. UVs, two per edge, where the surface has some. Throws Cancelled.
LineSet crack_lines(const Result& result, const Context& context = {});

}  // namespace craze
