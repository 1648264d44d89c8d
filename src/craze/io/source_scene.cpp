#include "craze/io/source_scene.h"

#include <algorithm>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"

namespace craze {

namespace {

/// The first ones.
std::string told(const std::vector<std::string>& names) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    text += (i == 0 ? "" : " ") + printable(names[i]);
  }
  return text + (names.size() > most ? " and more" : "");
}

}  // namespace

std::string describe_lost(const std::vector<SceneContent>& contents,
                          const std::vector<std::string>& kept, const std::string& format) {
  std::string list;
  for (const SceneContent& content : contents) {
    if (std::find(kept.begin(), kept.end(), content.kind) != kept.end()) continue;
    list += list.empty() ? "" : ", ";
    list += content.tells_names ? fmt::format("{} {}", content.kind, told(content.names))
                                : fmt::format("{} {}", content.names.size(), content.kind);
  }
  if (list.empty()) return list;
  return fmt::format("not kept of the input, since {} has no place for them: {}", format, list);
}

}  // namespace craze
