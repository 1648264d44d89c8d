// What a finished run says of itself, whatever surface it ran on.
#pragma once

#include "craze/engine/cycles.h"
#include "craze/engine/roughness/rough_network.h"
#include "craze/model/crack_network.h"
#include "craze/report.h"

namespace craze {

/// post.gap for which cracks open by post.gap_width on average over their length.
void resolve_gap(PostParameters& post, const CrackNetwork& network);

/// post.roughness where post.relative_roughness says it, of the cracks as they grew.
void resolve_roughness(PostParameters& post, const CrackNetwork& network);

/// What [post] says of roughness, of a resolved recipe; what never fails is closed to rough lines.
RoughnessOptions roughness_options(const Recipe& recipe, const Simulation& simulation);

/// Adds to the report where the cracks' lines could not be as rough or as fine as asked.
void warn_of_roughness(Report& report, const Recipe& recipe, const RoughNetwork& rough);

/// Adds to the report what the user should know of how the cracking ended. Wants its `recipe`,
/// `carried` and `cracks`; `last` may have given its simulation away.
void add_run_warnings(Report& report, const LastCycle& last, const Simulation& simulation);

}  // namespace craze
