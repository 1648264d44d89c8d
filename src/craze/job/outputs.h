// The files of a run.
#pragma once

#include <optional>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/job/run.h"
#include "craze/output/source_file.h"
#include "craze/products/statistics/statistics.h"
#include "craze/render/light/environment.h"
#include "craze/render/material/look.h"

namespace craze {

/// What a run's input brought besides its surface.
struct BesideSurface {
  SourceFile source;
  std::vector<render::Look> looks;  ///< what pictures show of it; empty: their own material
  std::vector<std::vector<Vec2>> further_uvs;  ///< that the looks read: 3 #F of the input each
  std::shared_ptr<const render::Environment> environment;  ///< what lights them; null: the studio
};

/// Writes everything asked for but the report, of which it counts the output and adds warnings.
/// Returns the statistics of the pattern where a report is asked for and there are cracks. Throws
/// Error(output), and Cancelled, with every file whole or not there.
std::optional<StatisticsWithSensitivity> write_outputs(const RunRequest& request,
                                                       const Result& result,
                                                       const BesideSurface& beside, Report& report,
                                                       const Context& context);

}  // namespace craze
