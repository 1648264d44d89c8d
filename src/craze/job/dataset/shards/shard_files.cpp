#include "craze/job/dataset/shards/shard_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/bytes/sha256.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/new_file.h"
#include "craze/io/files/read_file.h"
#include "craze/io/files/tar.h"
#include "craze/job/dataset/shards/coco.h"
#include "craze/job/output_folder.h"
#include "craze/job/plan/plan_folder.h"
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

void make_folders(const DatasetPlan& plan, const fs::path& folder) {
  make_output_folder("the shards", folder / "shards");
  if (!plan.shape.folders) return;
  make_output_folder("the images", folder / "images");
  make_output_folder("the masks", folder / "masks");
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
      if (const auto path = path_beside(plan_.shape, folder_, sample.id, file.kind)) {
        write_file(*path, file.bytes, failure, context_);
      }
    }
    coco_.add(sample, index, plan_.shape.width, plan_.shape.height);
    mark_.sums += sample.sums;
    ++mark_.samples;
  }

  /// Takes the samples of a shard of that marker; false, and good for nothing more, where the
  /// archive or its boxes are not what it says.
  bool take(const ShardPaths& paths, const ShardMark& mark) {
    try {
      TarReader tar(paths.tar);
      std::string name, bytes;
      while (tar.next(name, bytes)) {
        context_.check();
        append(tar_entry(name, bytes));
      }
      const std::string boxes = read_file(paths.coco, "cannot read a shard's boxes");
      Sha256 as_it_was = hash_;
      as_it_was.add(tar_end());
      if (as_it_was.hex() != mark.tar_sha256 || sha256(boxes) != mark.coco_sha256) return false;
      coco_.add(boxes, paths.coco);
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::input) throw;
      return false;
    }
    mark_.sums = mark.sums;
    mark_.samples = mark.samples;
    return true;
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

/// Of any number of samples.
std::optional<ShardMark> marker_there(const DatasetShape& shape, const fs::path& folder,
                                      std::uint64_t shard) {
  const ShardPaths paths = shard_paths(folder, shard);
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
    if (mark.first != shard * shape.shard_samples) return std::nullopt;
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

/// Makes the samples [begin, end).
void add_samples(ShardWriter& writer, const DatasetPlan& plan, std::uint64_t begin,
                 std::uint64_t end, const Context& context) {
  const std::uint64_t first = begin;
  const auto at_once = static_cast<std::uint64_t>(std::max(1, context.threads.count()));
  for (; begin < end; begin += at_once) {
    context.check();
    const auto reached = static_cast<double>(begin - first);
    context.report({"dataset", reached / static_cast<double>(end - first)});
    std::vector<Sample> samples(std::min(at_once, end - begin));
    side_by_side(samples.size(), context, [&](std::size_t i, const Context& own) {
      samples[i] = make_sample(plan, begin + i, own);
    });
    for (std::size_t i = 0; i < samples.size(); ++i) writer.add(samples[i], begin + i);
  }
}

}  // namespace

ShardPaths shard_paths(const fs::path& folder, std::uint64_t shard) {
  const fs::path base = folder / "shards";
  return {base / fmt::format("{:06}.tar", shard), base / fmt::format("{:06}.coco.json", shard),
          base / fmt::format("{:06}.json", shard)};
}

std::optional<fs::path> path_beside(const DatasetShape& shape, const fs::path& folder,
                                    const std::string& id, const std::string& kind) {
  const bool image = kind == "image.png";
  if (!shape.folders || (!image && kind != "mask.png")) return std::nullopt;
  return folder / (image ? "images" : "masks") / (id + ".png");
}

std::optional<ShardMark> read_mark(const DatasetShape& shape, const fs::path& folder,
                                   std::uint64_t shard) {
  auto mark = marker_there(shape, folder, shard);
  if (mark && mark->samples != shape.samples_of(shard)) mark.reset();
  return mark;
}

std::optional<ShardMark> read_shorter_mark(const DatasetShape& shape, const fs::path& folder,
                                           std::uint64_t shard) {
  auto mark = marker_there(shape, folder, shard);
  if (mark && mark->samples >= shape.samples_of(shard)) mark.reset();
  return mark;
}

std::vector<CocoFile> coco_files(const DatasetShape& shape, const fs::path& folder) {
  std::vector<CocoFile> files;
  for (std::uint64_t s = 0; s < shape.shards(); ++s) {
    const auto mark = read_mark(shape, folder, s);
    files.push_back({shard_paths(folder, s).coco, mark ? mark->coco_sha256 : ""});
  }
  return files;
}

ShardMark write_shard(const DatasetPlan& plan, const fs::path& folder, std::uint64_t shard,
                      const Context& context) {
  const ShardPaths paths = shard_paths(folder, shard);
  make_folders(plan, folder);
  const std::uint64_t first = shard * plan.shape.shard_samples;
  const std::uint64_t count = plan.shape.samples_of(shard);
  std::optional<ShardWriter> writer;
  std::uint64_t taken = 0;
  if (const auto shorter = read_shorter_mark(plan.shape, folder, shard)) {
    writer.emplace(plan, folder, paths, context);
    taken = writer->take(paths, *shorter) ? shorter->samples : 0;
  }
  if (taken == 0) writer.emplace(plan, folder, paths, context);
  add_samples(*writer, plan, first + taken, first + count, context);
  // A larger set may have begun meanwhile, which holds more in this place.
  if (count < plan.shape.shard_samples) check_claim(folder, plan.source);
  const ShardMark mark = writer->finish(paths, first);
  context.report({"dataset", 1});
  return mark;
}

void restore_beside(const DatasetPlan& plan, const fs::path& folder, std::uint64_t shard,
                    const Context& context) {
  if (!plan.shape.folders || !read_mark(plan.shape, folder, shard)) return;
  const std::uint64_t first = shard * plan.shape.shard_samples;
  bool all_there = true;
  for (std::uint64_t i = first; i < first + plan.shape.samples_of(shard); ++i) {
    for (const char* kind : {"image.png", "mask.png"}) {
      all_there =
          all_there && fs::is_regular_file(*path_beside(plan.shape, folder, sample_id(i), kind));
    }
  }
  if (all_there) return;
  make_folders(plan, folder);
  TarReader tar(shard_paths(folder, shard).tar);
  std::string name, bytes;
  while (tar.next(name, bytes)) {
    context.check();
    const std::size_t dot = name.find('.');
    const auto path = path_beside(plan.shape, folder, name.substr(0, dot),
                                  name.substr(std::min(dot, name.size() - 1) + 1));
    if (path && !fs::is_regular_file(*path)) write_file(*path, bytes, failure, context);
  }
}

}  // namespace craze
