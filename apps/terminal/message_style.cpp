#include "terminal/message_style.h"

#include <string_view>

namespace craze::app {

MessageStyle message_style(int argc, const char* const* argv) {
  MessageStyle style = MessageStyle::line;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const bool next_is_json = i + 1 < argc && std::string_view(argv[i + 1]) == "json";
    if (word == "--progress=json" || (word == "--progress" && next_is_json)) {
      style = MessageStyle::json;
    }
  }
  return style;
}

}  // namespace craze::app
