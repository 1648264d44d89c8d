#include "craze/job/dataset/dataset.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>

#include "craze/base/progress_meter.h"
#include "craze/base/version.h"
#include "craze/error.h"
#include "craze/io/bytes/sha256.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/new_file.h"
#include "craze/io/files/read_file.h"
#include "craze/io/files/tar.h"
#include "craze/job/dataset/dataset_growth.h"
#include "craze/job/dataset/shards/coco.h"
#include "craze/job/dataset/shards/croissant.h"
#include "craze/job/dataset/shards/shard_files.h"
#include "craze/job/load_textures.h"
#include "craze/job/plan/plan_text.h"
#include "craze/output/source_file.h"
#include "craze/recipe/json_table.h"
#include "craze/recipe/set_key.h"
#include "craze/recipe/toml_text.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// What joins the shards; none of these is needed to go on.
void write_summary(const DatasetPlan& plan, const fs::path& folder, const Context& context) {
  constexpr const char* failure = "cannot write the set's summary";
  NewFile boxes(folder / "coco.json", failure, context);
  join_coco(coco_files(plan.shape, folder), context,
            [&](std::string_view piece) { boxes.append(piece); });
  boxes.finish();
  write_file(folder / "croissant.json", croissant_json(plan, folder), failure, context);
  write_file(folder / "dataset.json", dataset_json(plan, folder), failure, context);
}

/// Before hours of work: whether the pictures that samples may draw are there.
void check_textures(const DatasetPlan& plan) {
  const std::string recipe_prefix = "recipe.";
  for (const PlanEntry& entry : plan.plan.entries()) {
    if (!entry.key.starts_with(recipe_prefix) || !entry.key.ends_with("texture")) continue;
    for (const PlanValue& value : extremes(entry.distribution)) {
      Recipe recipe;
      set_key(recipe, entry.key.substr(recipe_prefix.size()), plan_text(value), entry.where);
      const TextureFolder beside = texture_folder(plan.source.folder, recipe);
      for (const NamedTexture& texture : named_textures(recipe)) find_texture(texture, beside);
    }
  }
}

/// The same of meshes.
void check_objects(const DatasetPlan& plan) {
  for (const PlanEntry& entry : plan.plan.entries()) {
    if (entry.key != "object.mesh") continue;
    for (const PlanValue& value : extremes(entry.distribution)) {
      const std::string name = plan_text(value);
      std::error_code failed;
      if (is_shape(name) || fs::exists(plan.source.folder / name, failed)) continue;
      throw Error(ErrorKind::input, "no mesh " + (plan.source.folder / name).string(), entry.where,
                  "give a file, a folder or shape:NAME");
    }
  }
}

}  // namespace

PlanSource with_samples(const PlanSource& source, std::uint64_t samples) {
  return {with_number(source.text, source.name, "samples", samples), source.name, source.folder};
}

DatasetResult make_dataset(const PlanSource& source, const fs::path& folder, Shard shard,
                           const Context& context) {
  const DatasetPlan plan(source);
  check_objects(plan);
  check_textures(plan);
  claim_dataset(plan, folder, context);
  DatasetResult result{plan.shape.samples, plan.shape.shards()};
  std::vector<std::uint64_t> wanted;
  for (std::uint64_t s = 0; s < result.shards; ++s) {
    if (shard.has(s) && !read_mark(plan.shape, folder, s)) wanted.push_back(s);
  }
  const auto share = 1 / static_cast<double>(wanted.size());
  for (const std::uint64_t s : wanted) {
    check_claim(folder, source);
    const auto before = static_cast<double>(result.shards_made);
    write_shard(plan, folder, s,
                phase_part(context, "dataset", before * share, (before + 1) * share));
    ++result.shards_made;
  }
  if (!wanted.empty()) context.report({"dataset", 1});
  for (std::uint64_t s = 0; s < result.shards; ++s) {
    if (!read_mark(plan.shape, folder, s)) ++result.shards_left;
  }
  check_claim(folder, source);
  if (result.shards_left == 0) write_summary(plan, folder, context);
  return result;
}

RemadeSample remake_sample(const fs::path& folder, const std::string& id, const Context& context) {
  const DatasetPlan plan(plan_of_folder(folder));
  std::uint64_t index = 0;
  const auto read = std::from_chars(id.data(), id.data() + id.size(), index);
  if (read.ec != std::errc() || read.ptr != id.data() + id.size() || index >= plan.shape.samples) {
    throw Error(ErrorKind::usage, "no sample " + id, folder.string(),
                fmt::format("they are 0 to {}", plan.shape.samples - 1));
  }
  RemadeSample remade{make_sample(plan, index, context), {}};
  std::map<std::string, std::string> held;
  TarReader tar(shard_paths(folder, index / plan.shape.shard_samples).tar);
  std::string name, bytes;
  const std::string prefix = sample_id(index) + ".";
  while (tar.next(name, bytes)) {
    if (name.compare(0, prefix.size(), prefix) == 0) held[name.substr(prefix.size())] = bytes;
  }
  for (const SampleFile& file : remade.sample.files) {
    if (held[file.kind] != file.bytes) remade.differing.push_back(file.kind);
  }
  return remade;
}

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

}  // namespace craze
