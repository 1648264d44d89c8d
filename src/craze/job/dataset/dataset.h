// Labelled pictures by the hundred thousand, on any number of machines, stopped at any time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/job/dataset/sample.h"
#include "craze/job/plan/plan_folder.h"
#include "craze/job/plan/shard.h"

namespace craze {

struct DatasetResult {
  std::uint64_t samples = 0;      ///< of the plan
  std::uint64_t shards = 0;       ///< of the plan
  std::uint64_t shards_made = 0;  ///< now
  std::uint64_t shards_left = 0;  ///< not there yet, of any --shard
};

/// The plan with another number of samples: its text with that number in place of its own, or,
/// where it has none, in a line in front. Throws Error(usage) where it is no TOML.
PlanSource with_samples(const PlanSource& source, std::uint64_t samples);

/// Makes the archives of a shard that are not there yet (shard_files.h). A set that is there goes
/// on to more samples (dataset_growth.h). Where none is missing, of whatever shard, writes
/// coco.json, croissant.json and dataset.json of all. Archives do not depend on the shards, on
/// threads or on where a run was stopped. Throws Error and Cancelled; archives made until then
/// stay.
DatasetResult make_dataset(const PlanSource& source, const std::filesystem::path& folder,
                           Shard shard, const Context& context);

/// A sample made again beside what the set holds: the kinds of files that differ; and the files.
struct RemadeSample {
  Sample sample;
  std::vector<std::string> differing;
};
/// Throws Error(usage) where the set has no such sample, Error(input) where its archive cannot be
/// read.
RemadeSample remake_sample(const std::filesystem::path& folder, const std::string& id,
                           const Context& context);

}  // namespace craze
