#include "craze/job/dataset/dataset.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "craze/base/progress_meter.h"
#include "craze/base/version.h"
#include "craze/error.h"
#include "craze/io/bytes/sha256.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/read_file.h"
#include "craze/io/files/tar.h"
#include "craze/job/dataset/shards/coco.h"
#include "craze/job/dataset/shards/croissant.h"
#include "craze/job/dataset/shards/shard_files.h"
#include "craze/job/load_textures.h"
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
  std::vector<fs::path> parts;
  for (std::uint64_t s = 0; s < plan.shape.shards(); ++s) {
    parts.push_back(shard_paths(folder, s).coco);
  }
  join_coco(parts, folder / "coco.json", context);
  constexpr const char* failure = "cannot write the set's summary";
  write_file(folder / "croissant.json", croissant_json(plan, folder), failure, context);
  write_file(folder / "dataset.json", dataset_json(plan, folder), failure, context);
}

/// Checks an archive against its marker, each sample against its own JSON and the plan, and the
/// files that lie beside the archives against what is in them.
class ShardCheck {
 public:
  ShardCheck(const DatasetPlan& plan, const fs::path& folder, std::string name,
             std::vector<std::string>& faults)
      : plan_(plan),
        folder_(folder),
        plan_sha256_(sha256(plan.source.text)),
        name_(std::move(name)),
        faults_(faults) {}

  void run(const ShardPaths& paths, const ShardMark& mark) {
    if (sha256_of(paths.tar) != mark.tar_sha256) fault("its archive is not what its marker says");
    if (sha256_of(paths.coco) != mark.coco_sha256) fault("its boxes are not what its marker says");
    try {
      check_samples(paths, mark);
    } catch (const Error& e) {
      fault(e.what());
    } catch (const nlohmann::json::exception&) {
      fault("a sample's JSON is damaged");
    }
  }

 private:
  void fault(const std::string& what) { faults_.push_back("shard " + name_ + ": " + what); }

  static std::string sha256_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string part(std::size_t{1} << 20, '\0');
    Sha256 hash;
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())), file.gcount() > 0) {
      hash.add(std::string_view(part).substr(0, static_cast<std::size_t>(file.gcount())));
    }
    return hash.hex();
  }

  void check_samples(const ShardPaths& paths, const ShardMark& mark) {
    TarReader tar(paths.tar);
    std::map<std::string, std::string> hashes;  // of the sample's files so far
    std::uint64_t index = mark.first;
    std::string name, bytes;
    while (tar.next(name, bytes)) {
      const std::size_t dot = name.find('.');
      const std::string id = name.substr(0, dot), kind = name.substr(dot + 1);
      if (id != sample_id(index)) return fault("it holds " + name + " out of place");
      if (kind != "json") {
        hashes[kind] = sha256(bytes);
        check_beside(id, kind, hashes[kind]);
        continue;
      }
      const Json json = Json::parse(bytes);
      if (json.at("sha256").get<std::map<std::string, std::string>>() != hashes) {
        fault("the files of sample " + id + " are not what its JSON says");
      }
      if (json.at("plan_sha256") != plan_sha256_) {
        fault("sample " + id + " is of another plan than plan.toml");
      }
      hashes.clear();
      ++index;
    }
    if (index != mark.first + mark.samples || !hashes.empty()) fault("samples are missing");
  }

  /// images/ and masks/, where the plan has them.
  void check_beside(const std::string& id, const std::string& kind, const std::string& hash) {
    const bool image = kind == "image.png";
    if (!plan_.shape.folders || (!image && kind != "mask.png")) return;
    const fs::path file = fs::path(image ? "images" : "masks") / (id + ".png");
    if (sha256_of(folder_ / file) != hash) {
      fault(file.string() + " is not what its archive has");
    }
  }

  const DatasetPlan& plan_;
  const fs::path& folder_;
  std::string plan_sha256_, name_;
  std::vector<std::string>& faults_;
};

/// Of a place that the TOML library names, bytes from the start. Its columns count characters.
std::size_t offset_of(const std::string& text, const toml::source_position& place) {
  std::size_t at = 0;
  for (toml::source_index line = 1; line < place.line; ++line) at = text.find('\n', at) + 1;
  const auto continues = [&] { return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80; };
  for (toml::source_index column = 1; column < place.column && at < text.size(); ++column) {
    do ++at;
    while (at < text.size() && continues());
  }
  return at;
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
  if (is_json(source.text)) {
    Json json = Json::parse(source.text, nullptr, false);
    if (json.is_object()) json["samples"] = samples;
    return {json.is_object() ? json.dump(2) : source.text, source.name, source.folder};
  }
  const toml::table root = parse_toml(source.text, source.name, "plan");
  const toml::node* given = root.get("samples");
  std::string text = source.text;
  if (!given) {
    text.insert(0, fmt::format("samples = {}\n", samples));
  } else if (given->is_value()) {
    const toml::source_region at = given->source();
    const std::size_t from = offset_of(text, at.begin), to = offset_of(text, at.end);
    text.replace(from, to - from, fmt::format("{}", samples));
  }
  return {text, source.name, source.folder};
}

DatasetResult make_dataset(const PlanSource& source, const fs::path& folder, Shard shard,
                           const Context& context) {
  const DatasetPlan plan(source);
  check_objects(plan);
  check_textures(plan);
  claim_plan_folder(folder, source, "dataset", context);
  DatasetResult result{plan.shape.samples, plan.shape.shards()};
  std::vector<std::uint64_t> wanted;
  for (std::uint64_t s = 0; s < result.shards; ++s) {
    if (shard.has(s) && !read_mark(plan.shape, folder, s)) wanted.push_back(s);
  }
  const auto share = 1 / static_cast<double>(wanted.size());
  for (const std::uint64_t s : wanted) {
    const auto before = static_cast<double>(result.shards_made);
    write_shard(plan, folder, s,
                phase_part(context, "dataset", before * share, (before + 1) * share));
    ++result.shards_made;
  }
  if (!wanted.empty()) context.report({"dataset", 1});
  for (std::uint64_t s = 0; s < result.shards; ++s) {
    if (!read_mark(plan.shape, folder, s)) ++result.shards_left;
  }
  if (result.shards_left == 0) write_summary(plan, folder, context);
  return result;
}

std::vector<std::string> verify_dataset(const fs::path& folder, const Context& context) {
  const DatasetPlan plan(plan_of_folder(folder));
  std::vector<std::string> faults;
  for (std::uint64_t s = 0; s < plan.shape.shards(); ++s) {
    context.check();
    context.report({"verify", static_cast<double>(s) / static_cast<double>(plan.shape.shards())});
    const ShardPaths paths = shard_paths(folder, s);
    const auto mark = read_mark(plan.shape, folder, s);
    const std::string name = paths.marker.stem().string();
    if (!mark) {
      faults.push_back("shard " + name + ": it is not there, or not whole");
    } else {
      ShardCheck(plan, folder, name, faults).run(paths, *mark);
    }
  }
  context.report({"verify", 1});
  std::error_code failed;
  const bool whole = faults.empty();
  for (const char* file : {"coco.json", "croissant.json", "dataset.json"}) {
    if (whole && !fs::is_regular_file(folder / file, failed)) {
      faults.push_back(std::string(file) + " is not there; make the set again to write it");
    }
  }
  return faults;
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
              {"plan_sha256", sha256(plan.source.text)},
              {"crack_share", of_all},
              {"crack_share_of_cracked", of_all * cracked},
              {"median_width_pixels", sums.median_width()},
              {"width_histogram",
               {{"bin_pixels", SampleSums::bin}, {"length_pixels", sums.length_by_width}}}}
             .dump(2) +
         "\n";
}

}  // namespace craze
