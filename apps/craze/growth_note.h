// What the command says where a larger plan goes on from a smaller one.
#pragma once

#include <optional>

#include "craze/job/plan/plan_growth.h"
#include "run_options.h"

namespace craze::app {

/// What grows, and what its parts are called.
struct GrowthWords {
  const char* whole;   ///< "the set"
  const char* pieces;  ///< "samples"
  const char* file;    ///< "shard"
};

/// One line on standard error; none with --quiet, or where nothing grows.
void print_growth(const RunOptions& options, const std::optional<PlanGrowth>& growth,
                  const GrowthWords& words);

}  // namespace craze::app
