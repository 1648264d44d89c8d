#include "craze/recipe/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "craze/error.h"
#include "craze/recipe/json_table.h"

namespace craze {

namespace {

constexpr int dots_limit = 16;

bool may_touch_a_key_dot(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) ||
         std::string_view("_-\"' \t").find(c) != std::string_view::npos;
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The end of the string that begins with the quote at `begin`; one that is not closed ends with
/// its line, or with the text if it may have many.
std::size_t end_of_string(std::string_view toml, std::size_t begin) {
  const char quote = toml[begin];
  const std::string three(3, quote);
  const bool many_lines = toml.substr(begin, 3) == three;
  const std::string_view closing = many_lines ? std::string_view(three) : toml.substr(begin, 1);
  std::size_t i = begin + closing.size();
  while (i < toml.size() && toml.substr(i, closing.size()) != closing) {
    if (toml[i] == '\n' && !many_lines) return i;
    i += quote == '"' && toml[i] == '\\' ? 2 : 1;
  }
  i = std::min(i + closing.size(), toml.size());
  // Up to two more quotes before the closing three belong to the string.
  for (int more = 0; many_lines && more < 2 && i < toml.size() && toml[i] == quote; ++more) ++i;
  return i;
}

}  // namespace

std::size_t find_bare_non_ascii(std::string_view toml) {
  std::size_t i = toml.substr(0, byte_order_mark.size()) == byte_order_mark ? 3 : 0;
  while (i < toml.size()) {
    if (static_cast<unsigned char>(toml[i]) >= 0x80) return i;
    if (toml[i] == '"' || toml[i] == '\'') {
      i = end_of_string(toml, i);
    } else if (toml[i] == '#') {
      i = std::min(toml.find('\n', i), toml.size());
    } else {
      ++i;
    }
  }
  return std::string_view::npos;
}

void check_toml_nesting(std::string_view text, const std::string& name, const std::string& what) {
  int dots = 0;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == '=' || text[i] == '\n' || text[i] == ',') dots = 0;
    if (text[i] != '.') continue;
    if (may_touch_a_key_dot(text[i - 1]) && may_touch_a_key_dot(text[i + 1]) &&
        ++dots > dots_limit) {
      throw Error(ErrorKind::usage, "not a " + what, name, "keys nested too deep");
    }
  }
}

toml::table parse_toml(std::string_view text, const std::string& name, const std::string& what) {
  if (text.size() > toml_size_limit) {
    throw Error(ErrorKind::usage, "not a " + what, name,
                fmt::format("larger than {} bytes", toml_size_limit));
  }
  if (is_json(text)) return read_json_table(text, name);
  check_toml_nesting(text, name, what);
  if (const std::size_t at = find_bare_non_ascii(text); at != std::string_view::npos) {
    const std::string_view before = text.substr(0, at);
    throw Error(ErrorKind::usage, "not a TOML " + what,
                fmt::format("{}:{}", name, std::count(before.begin(), before.end(), '\n') + 1),
                "a character that is not ASCII must stand in quotes");
  }
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& e) {
    const auto at = e.source().begin;
    std::string why(e.description());
    why = why.substr(0, why.find('\n'));
    throw Error(ErrorKind::usage, "not a TOML " + what,
                fmt::format("{}:{}:{}", name, at.line, at.column), why);
  }
}

}  // namespace craze
