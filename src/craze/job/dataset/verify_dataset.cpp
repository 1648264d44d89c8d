#include "craze/job/dataset/verify_dataset.h"

#include <charconv>
#include <map>
#include <nlohmann/json.hpp>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/bytes/sha256.h"
#include "craze/io/files/hash_file.h"
#include "craze/io/files/tar.h"
#include "craze/job/dataset/set_summary.h"
#include "craze/job/dataset/shards/shard_files.h"

namespace craze {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// Checks an archive against its marker and what that says of it, each sample against its own JSON
/// and the plan, and the files that lie beside the archives against what is in them.
class ShardCheck {
 public:
  ShardCheck(const DatasetPlan& plan, const fs::path& folder, std::string name,
             std::vector<std::string>& faults)
      : plan_(plan), folder_(folder), name_(std::move(name)), faults_(faults) {}

  void run(const ShardPaths& paths, const ShardMark& mark) {
    if (sha256_of_file(paths.tar) != mark.tar_sha256)
      fault("its archive is not what its marker says");
    if (sha256_of_file(paths.coco) != mark.coco_sha256)
      fault("its boxes are not what its marker says");
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
    const auto file = path_beside(plan_.shape, folder_, id, kind);
    if (file && sha256_of_file(*file) != hash) {
      fault(file->lexically_relative(folder_).string() + " is not what its archive has");
    }
  }

  const DatasetPlan& plan_;
  const fs::path& folder_;
  std::string name_;
  std::vector<std::string>& faults_;
};

/// Shards that are not there or not whole; those that follow each other are one fault.
class MissingShards {
 public:
  explicit MissingShards(std::vector<std::string>& faults) : faults_(faults) {}

  void add(std::uint64_t shard) {
    if (count_ == 0) first_ = shard;
    ++count_;
  }
  void tell() {
    if (count_ == 1) {
      faults_.push_back(fmt::format("shard {:06}: it is not there, or not whole", first_));
    } else if (count_ > 1) {
      faults_.push_back(fmt::format("shards {:06} to {:06}: they are not there, or not whole",
                                    first_, first_ + count_ - 1));
    }
    count_ = 0;
  }

 private:
  std::vector<std::string>& faults_;
  std::uint64_t first_ = 0, count_ = 0;
};

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
  const DatasetPlan plan(plan_of_folder(folder, "dataset"));
  std::vector<std::string> faults;
  MissingShards missing(faults);
  for (std::uint64_t s = 0; s < plan.shape.shards(); ++s) {
    context.check();
    context.report({"verify", static_cast<double>(s) / static_cast<double>(plan.shape.shards())});
    const auto mark = read_mark(plan.shape, folder, s);
    const auto shorter = mark ? std::nullopt : read_shorter_mark(plan.shape, folder, s);
    if (!mark && !shorter) {
      missing.add(s);
      continue;
    }
    missing.tell();
    if (mark) {
      ShardCheck(plan, folder, fmt::format("{:06}", s), faults).run(shard_paths(folder, s), *mark);
    } else {
      faults.push_back(fmt::format("shard {:06}: it holds {} of its {} samples", s,
                                   shorter->samples, plan.shape.samples_of(s)));
    }
  }
  missing.tell();
  context.report({"verify", 1});
  check_beyond(folder / "shards", plan.shape.shards(), "shards", faults);
  for (const char* beside : {"images", "masks"}) {
    check_beyond(folder / beside, plan.shape.samples, "samples", faults);
  }
  if (!faults.empty()) return faults;
  for (const std::string& name : stale_summaries(plan, folder, context)) {
    faults.push_back(name + " is not that of these shards; make the set again to write it");
  }
  return faults;
}

}  // namespace craze
