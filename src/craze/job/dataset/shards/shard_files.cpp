#include "craze/job/dataset/shards/shard_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "craze/error.h"
#include "craze/io/bytes/sha256.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/new_file.h"
#include "craze/io/files/read_file.h"
#include "craze/io/files/tar.h"
#include "craze/job/dataset/shards/coco.h"
#include "craze/job/output_folder.h"
#include "craze/job/plan/side_by_side.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* failure = "cannot write a shard";

std::string mark_text(const ShardMark& mark) {
  const Json json{{"first", mark.first},
                  {"samples", mark.samples},
                  {"bytes", mark.bytes},
                  {"tar_sha256", mark.tar_sha256},
                  {"coco_sha256", mark.coco_sha256},
                  {"clean", mark.sums.clean},
                  {"pixels", mark.sums.pixels},
                  {"crack_pixels", mark.sums.crack_pixels},
                  {"length_by_width", mark.sums.length_by_width}};
  return json.dump(1) + "\n";
}

/// What a shard is written to while it grows.
class ShardWriter {
 public:
  ShardWriter(const DatasetPlan& plan, const fs::path& folder, const ShardPaths& paths,
              const Context& context)
      : plan_(plan), folder_(folder), context_(context), tar_(paths.tar, failure, context) {}

  void add(const Sample& sample, std::uint64_t index) {
    for (const SampleFile& file : sample.files) {
      append(tar_entry(sample.id + "." + file.kind, file.bytes));
      const bool image = file.kind == "image.png";
      if (!plan_.shape.folders || (!image && file.kind != "mask.png")) continue;
      write_file(folder_ / (image ? "images" : "masks") / (sample.id + ".png"), file.bytes, failure,
                 context_);
    }
    coco_.add(sample, index, plan_.shape.width, plan_.shape.height);
    mark_.sums += sample.sums;
    ++mark_.samples;
  }

  ShardMark finish(const ShardPaths& paths, std::uint64_t first) {
    append(tar_end());
    tar_.finish();
    const std::string boxes = coco_.text();
    write_file(paths.coco, boxes, failure, context_);
    mark_.first = first;
    mark_.bytes = bytes_;
    mark_.tar_sha256 = hash_.hex();
    mark_.coco_sha256 = sha256(boxes);
    write_file(paths.marker, mark_text(mark_), failure, context_);
    return mark_;
  }

 private:
  void append(const std::string& bytes) {
    tar_.append(bytes);
    hash_.add(bytes);
    bytes_ += bytes.size();
  }

  const DatasetPlan& plan_;
  const fs::path& folder_;
  const Context& context_;
  NewFile tar_;
  Sha256 hash_;
  std::uint64_t bytes_ = 0;
  CocoPart coco_;
  ShardMark mark_;
};

}  // namespace

ShardPaths shard_paths(const fs::path& folder, std::uint64_t shard) {
  const fs::path base = folder / "shards";
  return {base / fmt::format("{:06}.tar", shard), base / fmt::format("{:06}.coco.json", shard),
          base / fmt::format("{:06}.json", shard)};
}

std::optional<ShardMark> read_mark(const DatasetShape& shape, const fs::path& folder,
                                   std::uint64_t shard) {
  const ShardPaths paths = shard_paths(folder, shard);
  const std::uint64_t first = shard * shape.shard_samples;
  std::error_code failed;
  if (!fs::is_regular_file(paths.marker, failed)) return std::nullopt;
  try {
    const Json json = Json::parse(read_file(paths.marker, "cannot read a shard's marker"));
    ShardMark mark;
    mark.first = json.at("first");
    mark.samples = json.at("samples");
    mark.bytes = json.at("bytes");
    mark.tar_sha256 = json.at("tar_sha256");
    mark.coco_sha256 = json.at("coco_sha256");
    if (mark.first != first) return std::nullopt;
    if (mark.samples != std::min(shape.shard_samples, shape.samples - first)) return std::nullopt;
    mark.sums.samples = mark.samples;
    mark.sums.clean = json.at("clean");
    mark.sums.pixels = json.at("pixels");
    mark.sums.crack_pixels = json.at("crack_pixels");
    mark.sums.length_by_width = json.at("length_by_width");
    if (fs::file_size(paths.tar, failed) != mark.bytes || failed) return std::nullopt;
    if (!fs::is_regular_file(paths.coco, failed)) return std::nullopt;
    return mark;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

ShardMark write_shard(const DatasetPlan& plan, const fs::path& folder, std::uint64_t shard,
                      const Context& context) {
  const ShardPaths paths = shard_paths(folder, shard);
  make_output_folder("the shards", folder / "shards");
  if (plan.shape.folders) {
    make_output_folder("the images", folder / "images");
    make_output_folder("the masks", folder / "masks");
  }
  const std::uint64_t first = shard * plan.shape.shard_samples;
  const std::uint64_t end = std::min(plan.shape.samples, first + plan.shape.shard_samples);
  ShardWriter writer(plan, folder, paths, context);
  const auto at_once = static_cast<std::uint64_t>(std::max(1, context.threads.count()));
  for (std::uint64_t begin = first; begin < end; begin += at_once) {
    context.check();
    const auto reached = static_cast<double>(begin - first);
    context.report({"dataset", reached / static_cast<double>(end - first)});
    std::vector<Sample> samples(std::min(at_once, end - begin));
    side_by_side(samples.size(), context, [&](std::size_t i, const Context& own) {
      samples[i] = make_sample(plan, begin + i, own);
    });
    for (std::size_t i = 0; i < samples.size(); ++i) writer.add(samples[i], begin + i);
  }
  ShardMark mark = writer.finish(paths, first);
  context.report({"dataset", 1});
  return mark;
}

}  // namespace craze
