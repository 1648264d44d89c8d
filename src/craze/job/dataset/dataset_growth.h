// A set that goes on where a smaller one ended.
#pragma once

#include <filesystem>
#include <optional>

#include "craze/job/dataset/sample.h"
#include "craze/job/plan/plan_growth.h"

namespace craze {

/// What making a set will do to a smaller one that is there; none: there is none.
std::optional<PlanGrowth> dataset_growth(const PlanSource& source,
                                         const std::filesystem::path& folder);

/// Makes the folder the plan's (claim_plan_folder). A set of the same plan with fewer samples
/// becomes one with more. Throws Error(usage) where it has more than the plan asks for.
void claim_dataset(const DatasetPlan& plan, const std::filesystem::path& folder,
                   const Context& context);

}  // namespace craze
