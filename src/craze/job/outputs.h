// The files of a run.
#pragma once

#include <optional>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/job/material_looks.h"
#include "craze/job/run.h"
#include "craze/products/statistics/statistics.h"

namespace craze {

/// Writes everything asked for but the report, of which it counts the output and adds warnings.
/// `looks`: how the input's own materials look.
/// Returns the statistics of the pattern where a report is asked for and there are cracks. Throws
/// Error(output), and Cancelled, with every file whole or not there.
std::optional<StatisticsWithSensitivity> write_outputs(const RunRequest& request,
                                                       const Result& result,
                                                       const MaterialLooks& looks, Report& report,
                                                       const Context& context);

}  // namespace craze
