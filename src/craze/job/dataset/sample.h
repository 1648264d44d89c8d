// One sample of a dataset: a picture and everything known of its cracks.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/job/dataset/dataset_plan.h"
#include "craze/job/plan/plan_folder.h"

namespace craze {

/// Files of a sample by what they are, "image.png": docs/datasets.md says what is in each.
struct SampleFile {
  std::string kind, bytes;
};

/// What the labels of a picture sum to.
struct SampleSums {
  static constexpr double bin = 0.5;  ///< of the widths, pixels
  static constexpr int bins = 64;     ///< the last one has all that are wider

  std::uint64_t samples = 0, clean = 0;
  std::uint64_t pixels = 0, crack_pixels = 0;
  std::array<double, bins> length_by_width{};  ///< pixels of centre lines that are seen

  SampleSums& operator+=(const SampleSums& other);
  /// Half of the centre lines' length is narrower, pixels; 0 where there are none.
  double median_width() const;
};

/// A crack in a picture's mask.
struct SampleInstance {
  std::int32_t order = 0;          ///< the crack's, from 1
  std::vector<std::uint8_t> mask;  ///< width · height, 0 or 1
};

struct Sample {
  std::string id;                 ///< the index in nine digits
  std::vector<SampleFile> files;  ///< the JSON last: it has the hashes of the others
  SampleSums sums;
  std::vector<SampleInstance> instances;
};

/// The plan of a set, read once. Throws Error(usage) for more than a million shards, and for what
/// [post] asks besides rough lines.
struct DatasetPlan {
  explicit DatasetPlan(const PlanSource& from);

  PlanSource source;
  Plan plan;
  DatasetShape shape;
  std::string sha256;  ///< of the plan's identity: the same however many samples it asks for
};

std::string sample_id(std::uint64_t index);

/// A function of the plan and the index. A sample with cracks is drawn again, as often as the plan
/// says, until its mask shows one. Throws Error(request) where none does, Error for what the values
/// ask that cannot be done, naming the sample, and Cancelled.
Sample make_sample(const DatasetPlan& plan, std::uint64_t index, const Context& context);

}  // namespace craze
