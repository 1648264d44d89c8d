#include "craze/job/dataset/set_summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "craze/base/version.h"
#include "craze/io/bytes/sha256.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/hash_file.h"
#include "craze/io/files/new_file.h"
#include "craze/job/dataset/shards/coco.h"
#include "craze/job/dataset/shards/croissant.h"
#include "craze/job/dataset/shards/shard_files.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* boxes_file = "coco.json";
constexpr const char* croissant_file = "croissant.json";
constexpr const char* statistics_file = "dataset.json";

std::string joined_sha256(const DatasetPlan& plan, const fs::path& folder, const Context& context) {
  Sha256 hash;
  join_coco(coco_files(plan.shape, folder), context, [&](std::string_view p) { hash.add(p); });
  return hash.hex();
}

}  // namespace

std::string dataset_json(const DatasetPlan& plan, const fs::path& folder) {
  SampleSums sums;
  std::uint64_t bytes = 0;
  for (std::uint64_t s = 0; s < plan.shape.shards(); ++s) {
    const auto mark = read_mark(plan.shape, folder, s);
    if (!mark) continue;
    sums += mark->sums;
    bytes += mark->bytes;
  }
  const double pixels = std::max(1.0, static_cast<double>(sums.pixels));
  const double of_all = static_cast<double>(sums.crack_pixels) / pixels;
  const double cracked =
      sums.samples > sums.clean
          ? static_cast<double>(sums.samples) / static_cast<double>(sums.samples - sums.clean)
          : 0;
  return Json{{"samples", sums.samples},
              {"clean", sums.clean},
              {"width", plan.shape.width},
              {"height", plan.shape.height},
              {"shards", plan.shape.shards()},
              {"bytes", bytes},
              {"version", version()},
              {"plan_sha256", plan.sha256},
              {"crack_share", of_all},
              {"crack_share_of_cracked", of_all * cracked},
              {"median_width_pixels", sums.median_width()},
              {"width_histogram",
               {{"bin_pixels", SampleSums::bin}, {"length_pixels", sums.length_by_width}}}}
             .dump(2) +
         "\n";
}

std::vector<std::string> stale_summaries(const DatasetPlan& plan, const fs::path& folder,
                                         const Context& context) {
  std::vector<std::string> stale;
  const auto check = [&](const char* name, const auto& hash_of_what_should_be) {
    std::error_code failed;
    if (fs::is_regular_file(folder / name, failed) &&
        sha256_of_file(folder / name) == hash_of_what_should_be()) {
      return;
    }
    stale.push_back(name);
  };
  check(boxes_file, [&] { return joined_sha256(plan, folder, context); });
  check(croissant_file, [&] { return sha256(croissant_json(plan, folder)); });
  check(statistics_file, [&] { return sha256(dataset_json(plan, folder)); });
  return stale;
}

void write_summary(const DatasetPlan& plan, const fs::path& folder, const Context& context) {
  constexpr const char* failure = "cannot write the set's summary";
  for (const std::string& name : stale_summaries(plan, folder, context)) {
    if (name != boxes_file) {
      const bool croissant = name == croissant_file;
      write_file(folder / name,
                 croissant ? croissant_json(plan, folder) : dataset_json(plan, folder), failure,
                 context);
      continue;
    }
    NewFile boxes(folder / name, failure, context);
    join_coco(coco_files(plan.shape, folder), context,
              [&](std::string_view piece) { boxes.append(piece); });
    boxes.finish();
  }
}

}  // namespace craze
