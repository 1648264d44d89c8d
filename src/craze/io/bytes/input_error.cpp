#include "craze/io/bytes/input_error.h"

#include "craze/error.h"

namespace craze {

void fail_input(const std::string& where, const std::string& why) {
  throw Error(ErrorKind::input, "cannot read mesh", where, why);
}

std::string at_line(const std::string& name, std::size_t line) {
  return name + ":" + std::to_string(line);
}

std::string printable(std::string_view bytes) {
  constexpr std::size_t longest = 40;
  std::string text(bytes.substr(0, longest));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return bytes.size() > longest ? text + "..." : text;
}

}  // namespace craze
