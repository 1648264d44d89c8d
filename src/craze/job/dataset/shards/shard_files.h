// The shards of a dataset: an archive, its boxes, and a marker that says that both are whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/job/dataset/sample.h"
#include "craze/job/dataset/shards/coco.h"

namespace craze {

struct ShardPaths {
  std::filesystem::path tar, coco, marker;
};

/// FOLDER/shards/000017.tar, .coco.json, .json.
ShardPaths shard_paths(const std::filesystem::path& folder, std::uint64_t shard);

/// What a marker says.
struct ShardMark {
  std::uint64_t first = 0, samples = 0;  ///< the indices that are in it
  std::uint64_t bytes = 0;               ///< of the archive
  std::string tar_sha256, coco_sha256;
  SampleSums sums;
};

/// The file of a sample beside the archives, of those kinds that have one in such a set.
std::optional<std::filesystem::path> path_beside(const DatasetShape& shape,
                                                 const std::filesystem::path& folder,
                                                 const std::string& id, const std::string& kind);

/// The marker, where there is one, it is sound and the plan's, and the archive beside it has its
/// size.
std::optional<ShardMark> read_mark(const DatasetShape& shape, const std::filesystem::path& folder,
                                   std::uint64_t shard);

/// The same of a shard that a smaller set ended with: it holds fewer samples than the plan's.
std::optional<ShardMark> read_shorter_mark(const DatasetShape& shape,
                                           const std::filesystem::path& folder,
                                           std::uint64_t shard);

/// The boxes of all shards; what of one that is not whole hashes to is not known.
std::vector<CocoFile> coco_files(const DatasetShape& shape, const std::filesystem::path& folder);

/// Makes a shard, sample by sample: no more is in memory than one for each of the context's
/// threads. Samples of a shorter one are copied from there, where they are what its marker says.
/// The marker is written last. Reports "dataset". Each file is whole or not there. Throws Error and
/// Cancelled.
ShardMark write_shard(const DatasetPlan& plan, const std::filesystem::path& folder,
                      std::uint64_t shard, const Context& context);

/// Writes what is missing of a shard in images/ and masks/, from its archive; nothing where the
/// plan has none, or the shard is not whole. Throws as write_shard, and Error(input).
void restore_beside(const DatasetPlan& plan, const std::filesystem::path& folder,
                    std::uint64_t shard, const Context& context);

}  // namespace craze
