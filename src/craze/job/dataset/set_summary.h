// The files of all shards of a set together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/job/dataset/sample.h"

namespace craze {

/// The set's statistics as JSON: what dataset.json holds. Of the shards that are there.
std::string dataset_json(const DatasetPlan& plan, const std::filesystem::path& folder);

/// Which of coco.json, croissant.json and dataset.json are not there, or not those of the shards,
/// which must all be. Throws Error(input) for a shard's boxes that are damaged, and Cancelled.
std::vector<std::string> stale_summaries(const DatasetPlan& plan,
                                         const std::filesystem::path& folder,
                                         const Context& context);

/// Writes those. Throws so too, and Error(output).
void write_summary(const DatasetPlan& plan, const std::filesystem::path& folder,
                   const Context& context);

}  // namespace craze
