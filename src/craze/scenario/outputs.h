// The files of a run.
#pragma once

#include "craze/base/context.h"
#include "craze/mesh/surface_mesh.h"
#include "craze/model/simulation.h"
#include "craze/scenario/report.h"
#include "craze/scenario/run.h"

namespace craze {

/// Writes everything asked for but the report, and fills in the report's counts and statistics.
/// `surface` is what the simulation started with. Throws Error(output).
void write_outputs(const RunRequest& request, const SurfaceMesh& surface,
                   const Simulation& simulation, RunReport& report, const Context& context);

}  // namespace craze
