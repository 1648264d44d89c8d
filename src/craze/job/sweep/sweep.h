// Many runs over grids and random designs, as one table; on any number of machines, stopped at any
// time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/job/plan/plan_folder.h"
#include "craze/job/plan/plan_growth.h"
#include "craze/job/plan/shard.h"

namespace craze {

struct SweepResult {
  std::uint64_t rows = 0;        ///< of the plan
  std::uint64_t parts = 0;       ///< of the plan
  std::uint64_t parts_made = 0;  ///< now
  std::uint64_t parts_left = 0;  ///< not there yet, of any shard
  /// Where the table was joined: a sentence for each thing that is not as asked.
  std::vector<std::string> warnings;
};

/// What running a sweep will do to a table of fewer rows that is there; none: there is none.
std::optional<PlanGrowth> sweep_growth(const PlanSource& source,
                                       const std::filesystem::path& folder);

/// Runs the rows of a shard that are not there yet and writes them to FOLDER/parts, a file for each
/// part. Where no part is missing, of whatever shard, joins them to FOLDER/table.csv, columns/ (an
/// array for NumPy each) and plots/. Parts do not depend on the shards, on threads or on where a
/// run was stopped; a part that is there is whole and is kept. More draws, or more repeats of a
/// single point, go on where fewer ended; else the folder must hold the same plan. Rows run beside
/// each other on the context's threads. Throws Error and Cancelled; parts made until then stay.
SweepResult run_sweep(const PlanSource& source, const std::filesystem::path& folder, Shard shard,
                      const Context& context);

}  // namespace craze
