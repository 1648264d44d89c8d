#include "craze/job/dataset/dataset_growth.h"

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/job/dataset/shards/shard_files.h"

namespace craze {

namespace {

/// The folder's plan, where its samples are those of `plan`, however many.
std::optional<DatasetPlan> same_samples(const DatasetPlan& plan, const PlanSource& there) {
  try {
    DatasetPlan held(there);
    if (held.sha256 == plan.sha256) return held;
  } catch (const Error&) {  // of another craze, or damaged: another plan
  }
  return std::nullopt;
}

}  // namespace

std::optional<PlanGrowth> dataset_growth(const PlanSource& source,
                                         const std::filesystem::path& folder) {
  const DatasetPlan plan(source);
  const auto there = plan_there(folder);
  const auto held = there ? same_samples(plan, *there) : std::nullopt;
  if (!held || held->shape.samples >= plan.shape.samples) return std::nullopt;
  PlanGrowth growth{held->shape.samples, plan.shape.samples, {}, 0, 0};
  const std::uint64_t last = held->shape.shards() - 1;
  if (const auto mark = read_shorter_mark(plan.shape, folder, last)) {
    growth.piece = last;
    growth.held = mark->samples;
    growth.wanted = plan.shape.samples_of(last);
  }
  return growth;
}

void claim_dataset(const DatasetPlan& plan, const std::filesystem::path& folder,
                   const Context& context) {
  const auto goes_on = [&](const PlanSource& there) {
    const auto held = same_samples(plan, there);
    if (held && held->shape.samples > plan.shape.samples) {
      throw Error(ErrorKind::usage, "the folder holds a larger set", folder.string(),
                  fmt::format("{} samples there, {} asked for; give --samples {} or more, or an "
                              "empty folder",
                              held->shape.samples, plan.shape.samples, held->shape.samples));
    }
    return held.has_value();
  };
  claim_plan_folder(folder, plan.source, "dataset", goes_on, context);
}

}  // namespace craze
