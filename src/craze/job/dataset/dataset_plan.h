// What a dataset's plan may say.
#pragma once

#include <algorithm>
#include <cstdint>

#include "craze/job/plan/plan.h"

namespace craze {

/// The keys of dataset plans besides those of recipes.
const PlanSchema& dataset_schema();

/// The plan as a whole: what is the same for all samples.
struct DatasetShape {
  std::uint64_t samples = 0;
  std::uint64_t shard_samples = 0;
  int width = 0, height = 0;  ///< pixels
  double clean = 0;           ///< share of samples without a crack
  int attempts = 0;           ///< draws of a sample until a crack is seen
  bool folders = false;       ///< images and masks as files of their own too
  std::uint64_t points = 0;   ///< rays of a sample's point cloud; 0: it has none

  std::uint64_t shards() const { return (samples + shard_samples - 1) / shard_samples; }
  /// How many are in a shard, of which the last may have fewer.
  std::uint64_t samples_of(std::uint64_t shard) const {
    return std::min(shard_samples, samples - shard * shard_samples);
  }
};

DatasetShape dataset_shape(const Plan& plan);

}  // namespace craze
