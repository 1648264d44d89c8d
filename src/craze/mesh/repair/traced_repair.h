// A repaired surface that knows where in the input each of its faces lies.
#pragma once

#include "craze/mesh/repair/repair_origin.h"
#include "craze/repair.h"
#include "craze/surface_mesh.h"

namespace craze {

struct TracedSurface {
  SurfaceMesh surface;
  /// Per face of it. A face that was flipped lies the other way round than the triangle it names.
  RepairOrigin origin;
};

/// repair(), with the origin of what it returns.
TracedSurface traced_repair(const SurfaceMesh& input, const RepairOptions& options,
                            RepairReport& report, const Context& context);

}  // namespace craze
