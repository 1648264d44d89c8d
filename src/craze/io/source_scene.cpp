#include "craze/io/source_scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace craze {

std::string describe_lost(const std::vector<SceneContent>& contents,
                          const std::vector<std::string>& kept, const std::string& format) {
  std::string list;
  for (const SceneContent& content : contents) {
    if (std::find(kept.begin(), kept.end(), content.kind) != kept.end()) continue;
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", content.names.size(), content.kind);
  }
  if (list.empty()) return list;
  return fmt::format("not kept of the input, since {} has no place for them: {}", format, list);
}

}  // namespace craze
