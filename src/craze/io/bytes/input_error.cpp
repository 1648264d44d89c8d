#include "craze/io/bytes/input_error.h"

#include <algorithm>
#include <iterator>

#include "craze/base/text/utf8.h"
#include "craze/error.h"

namespace craze {

void fail_input(const std::string& where, const std::string& why) {
  throw Error(ErrorKind::input, "cannot read mesh", where, why);
}

std::string at_line(const std::string& name, std::size_t line) {
  return name + ":" + std::to_string(line);
}

namespace {

/// U+0080 to U+009F, marks that turn the direction of a line, and its ends.
bool is_control(std::string_view character) {
  constexpr std::string_view marks[] = {"\u200e", "\u200f", "\u2028", "\u2029"};
  if (std::find(std::begin(marks), std::end(marks), character) != std::end(marks)) return true;
  return (character >= "\xc2\x80" && character <= "\xc2\x9f") ||
         (character >= "\u202a" && character <= "\u202e") ||
         (character >= "\u2066" && character <= "\u2069");
}

}  // namespace

std::string printable(std::string_view bytes) {
  constexpr std::size_t longest = 40;
  std::string text;
  std::size_t at = 0;
  for (std::size_t shown = 0; shown < longest && at < bytes.size(); ++shown) {
    const std::size_t length = utf8_length(bytes, at);
    const std::string_view character = bytes.substr(at, std::max<std::size_t>(length, 1));
    const bool is_ascii = length == 1 && character[0] >= ' ' && character[0] <= '~';
    text += is_ascii || (length > 1 && !is_control(character)) ? character : "?";
    at += character.size();
  }
  return at < bytes.size() ? text + "..." : text;
}

}  // namespace craze
