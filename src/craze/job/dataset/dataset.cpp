#include "craze/job/dataset/dataset.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/files/tar.h"
#include "craze/job/dataset/dataset_growth.h"
#include "craze/job/dataset/scene/mesh_folder.h"
#include "craze/job/dataset/set_summary.h"
#include "craze/job/dataset/shards/shard_files.h"
#include "craze/job/load_textures.h"
#include "craze/job/plan/plan_text.h"
#include "craze/output/source_file.h"
#include "craze/recipe/set_key.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

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
      if (is_shape(name)) continue;
      const fs::path path = plan.source.folder / name;
      std::error_code failed;
      if (!fs::exists(path, failed)) {
        throw Error(ErrorKind::input, "no mesh " + path.string(), entry.where,
                    "give a file, a folder or shape:NAME");
      }
      if (fs::is_directory(path, failed)) meshes_in(path);
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
    if (shard.has(s)) restore_beside(plan, folder, s, context);
  }
  for (std::uint64_t s = 0; s < result.shards; ++s) {
    if (!read_mark(plan.shape, folder, s)) ++result.shards_left;
  }
  check_claim(folder, source);
  if (result.shards_left == 0) write_summary(plan, folder, context);
  return result;
}

RemadeSample remake_sample(const fs::path& folder, const std::string& id, const Context& context) {
  const DatasetPlan plan(plan_of_folder(folder, "dataset"));
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

}  // namespace craze
