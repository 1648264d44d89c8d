#include "craze/job/dataset/verify_dataset.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "craze/error.h"
#include "craze/io/bytes/sha256.h"
#include "craze/io/files/tar.h"
#include "craze/job/dataset/dataset.h"
#include "craze/job/dataset/shards/coco.h"
#include "craze/job/dataset/shards/croissant.h"
#include "craze/job/dataset/shards/shard_files.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

std::string sha256_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string part(std::size_t{1} << 20, '\0');
  Sha256 hash;
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())), file.gcount() > 0) {
    hash.add(std::string_view(part).substr(0, static_cast<std::size_t>(file.gcount())));
  }
  return hash.hex();
}

/// Checks an archive against its marker and what that says of it, each sample against its own JSON
/// and the plan, and the files that lie beside the archives against what is in them.
class ShardCheck {
 public:
  ShardCheck(const DatasetPlan& plan, const fs::path& folder, std::string name,
             std::vector<std::string>& faults)
      : plan_(plan), folder_(folder), name_(std::move(name)), faults_(faults) {}

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

  void check_samples(const ShardPaths& paths, const ShardMark& mark) {
    TarReader tar(paths.tar);
    std::map<std::string, std::string> hashes;  // of the sample's files so far
    std::uint64_t index = mark.first, clean = 0, crack_pixels = 0;
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
      if (json.at("plan_sha256") != plan_.sha256) {
        fault("sample " + id + " is of another plan than plan.toml");
      }
      clean += json.at("clean").get<bool>() ? 1 : 0;
      crack_pixels += json.at("crack_pixels").get<std::uint64_t>();
      hashes.clear();
      ++index;
    }
    if (index != mark.first + mark.samples || !hashes.empty()) return fault("samples are missing");
    const auto pixels = static_cast<std::uint64_t>(plan_.shape.width) *
                        static_cast<std::uint64_t>(plan_.shape.height) * mark.samples;
    const SampleSums& sums = mark.sums;
    if (sums.clean != clean || sums.crack_pixels != crack_pixels || sums.pixels != pixels) {
      fault("its marker's numbers are not its samples'");
    }
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
  std::string name_;
  std::vector<std::string>& faults_;
};

/// Of a shard whose marker is not the plan's.
std::string what_is_there(const DatasetPlan& plan, const fs::path& folder, std::uint64_t shard) {
  const auto shorter = read_shorter_mark(plan.shape, folder, shard);
  if (!shorter) return "it is not there, or not whole";
  return fmt::format("it holds {} of its {} samples; make the set again to go on", shorter->samples,
                     plan.shape.samples_of(shard));
}

/// The files of all shards together: each must be what is written of those that are there.
void check_summary(const DatasetPlan& plan, const fs::path& folder, const Context& context,
                   std::vector<std::string>& faults) {
  Sha256 boxes;
  join_coco(coco_files(plan.shape, folder), context, [&](std::string_view p) { boxes.add(p); });
  const std::pair<const char*, std::string> files[] = {
      {"coco.json", boxes.hex()},
      {"croissant.json", sha256(croissant_json(plan, folder))},
      {"dataset.json", sha256(dataset_json(plan, folder))}};
  for (const auto& file : files) {
    const std::string name = file.first;
    std::error_code failed;
    if (!fs::is_regular_file(folder / name, failed)) {
      faults.push_back(name + " is not there; make the set again to write it");
    } else if (sha256_of(folder / name) != file.second) {
      faults.push_back(name + " is not that of these shards; make the set again to write it");
    }
  }
}

/// Names that begin with a number of `limit` or more, which a smaller plan does not have.
void check_beyond(const fs::path& folder, std::uint64_t limit, const std::string& what,
                  std::vector<std::string>& faults) {
  std::error_code failed;
  std::uint64_t beyond = 0;
  std::string first;
  for (fs::directory_iterator i(folder, failed), end; !failed && i != end; i.increment(failed)) {
    const std::string name = i->path().filename().string();
    std::uint64_t number = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
    if (read.ec != std::errc() || *read.ptr != '.' || number < limit) continue;
    ++beyond;
    if (first.empty() || name < first) first = name;
  }
  if (beyond == 0) return;
  faults.push_back(fmt::format("{}/{}{} beyond the plan's {} {}", folder.filename().string(), first,
                               beyond == 1 ? " is" : fmt::format(" and {} others are", beyond - 1),
                               limit, what));
}

}  // namespace

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
      faults.push_back("shard " + name + ": " + what_is_there(plan, folder, s));
    } else {
      ShardCheck(plan, folder, name, faults).run(paths, *mark);
    }
  }
  context.report({"verify", 1});
  check_beyond(folder / "shards", plan.shape.shards(), "shards", faults);
  for (const char* beside : {"images", "masks"}) {
    check_beyond(folder / beside, plan.shape.samples, "samples", faults);
  }
  if (faults.empty()) check_summary(plan, folder, context, faults);
  return faults;
}

}  // namespace craze
