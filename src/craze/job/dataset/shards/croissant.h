// Croissant: what a dataset is, for programs that look for some.
#pragma once

#include <filesystem>
#include <string>

#include "craze/job/dataset/sample.h"

namespace craze {

/// JSON-LD by mlcommons.org/croissant/1.0, with the checksum of each archive. All shards must be
/// there.
std::string croissant_json(const DatasetPlan& plan, const std::filesystem::path& folder);

}  // namespace craze
