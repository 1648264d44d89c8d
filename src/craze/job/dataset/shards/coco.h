// Cracks as COCO's instances.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
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
  /// The boxes of another part, which come behind those there are. Throws Error(input) for a text
  /// that is none; `name` is the file's.
  void add(const std::string& text, const std::filesystem::path& name);
  std::string text() const;

 private:
  std::vector<std::string> images_, annotations_;
};

/// A part's file and what its bytes hash to.
struct CocoFile {
  std::filesystem::path path;
  std::string sha256;
};

/// Gives the pieces of all parts joined in their order to `put`, a part in memory at a time. Throws
/// Error(input) for a part whose bytes are others, and Cancelled.
void join_coco(const std::vector<CocoFile>& parts, const Context& context,
               const std::function<void(std::string_view)>& put);

}  // namespace craze
