// Cracks as COCO's instances.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/job/dataset/sample.h"

namespace craze {

/// A mask's runs down the columns, as pycocotools packs them into text.
std::string coco_runs(const std::vector<std::uint8_t>& mask, int width, int height);

/// The boxes of some samples: a whole COCO file of their own, a line for each picture and each
/// crack. Ids are the same in whatever part a sample is.
class CocoPart {
 public:
  void add(const Sample& sample, std::uint64_t index, int width, int height);
  std::string text() const;

 private:
  std::vector<std::string> images_, annotations_;
};

/// Joins parts in their order to one file, a part in memory at a time. Whole or not there.
void join_coco(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& path,
               const Context& context);

}  // namespace craze
