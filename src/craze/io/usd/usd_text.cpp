#include "craze/io/usd/usd_text.h"

#include <fmt/compile.h>

#include <algorithm>
#include <iterator>

#include "craze/base/text/format.h"
#include "craze/base/text/utf8.h"

namespace craze {

namespace {

template <class Number>
void append(std::string& out, Number number) {
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), number);
}

}  // namespace

void append_usd_number(std::string& out, float number) {
  append(out, number);
}
void append_usd_number(std::string& out, double number) {
  append(out, number);
}
void append_usd_number(std::string& out, std::int32_t number) {
  append(out, number);
}

std::string UsdNames::take(std::string_view name) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string identifier;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    identifier += is_letter || is_digit(c) ? c : '_';
  }
  if (identifier.empty() || is_digit(identifier[0])) identifier.insert(0, 1, '_');
  std::string free = identifier;
  for (int n = 1; !taken_.insert(free).second; ++n) free = fmt::format("{}_{}", identifier, n);
  return free;
}

std::string usd_string(std::string_view text) {
  constexpr std::string_view no_character = "\xef\xbf\xbd";  // U+FFFD
  std::string quoted = "\"";
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const char c = text[i];
    if (c == '"' || c == '\\') quoted += '\\';
    if (length == 0)
      quoted += no_character;
    else if (static_cast<unsigned char>(c) < 0x20)
      quoted += ' ';
    else
      quoted += text.substr(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return quoted + '"';
}

std::string usd_asset(std::string_view path) {
  const std::string around = path.find('@') == std::string_view::npos ? "@" : "@@@";
  std::string asset = around;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.substr(i, 3) == "@@@") asset += '\\';
    if (static_cast<unsigned char>(path[i]) >= 0x20) asset += path[i];
  }
  return asset + around;
}

}  // namespace craze
