#include "craze/recipe/toml_text.h"

#include <algorithm>
#include <cctype>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/recipe/json_table.h"

namespace craze {

namespace {

constexpr int dots_limit = 16;

bool may_touch_a_key_dot(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) ||
         std::string_view("_-\"' \t").find(c) != std::string_view::npos;
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF", blanks = " \t", line_ends = "\n\v\f\r";

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

/// Where the key of a header should be that begins with the bracket at `begin`.
std::size_t key_of_header(std::string_view toml, std::size_t begin) {
  std::size_t key = toml.find_first_not_of(blanks, begin + 1);
  if (key < toml.size() && toml[key] == '[') key = toml.find_first_not_of(blanks, key + 1);
  return key;
}

/// What begins a key, or shuts a header without one, which the library refuses by itself.
bool may_follow_header_bracket(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) ||
         std::string_view("_-\"']").find(c) != std::string_view::npos;
}

}  // namespace

std::optional<TomlFault> find_toml_fault(std::string_view toml) {
  bool at_line_start = true, in_header = false;
  int open = 0;  // brackets of arrays, whose lines begin with values
  std::size_t i = toml.substr(0, byte_order_mark.size()) == byte_order_mark ? 3 : 0;
  while (i < toml.size()) {
    const char c = toml[i];
    if (static_cast<unsigned char>(c) >= 0x80) {
      return TomlFault{i, "a character that is not ASCII must stand in quotes"};
    }
    if (at_line_start && open == 0 && c == '[') {
      const std::size_t key = key_of_header(toml, i);
      if (key < toml.size() && !may_follow_header_bracket(toml[key])) {
        return TomlFault{key, "a header must begin with a key"};
      }
      in_header = true;
    }
    if (line_ends.find(c) != std::string_view::npos) {
      at_line_start = true;
      in_header = false;
    } else if (blanks.find(c) == std::string_view::npos) {
      at_line_start = false;
    }
    if (!in_header) open = std::max(0, open + (c == '[') - (c == ']'));
    if (c == '"' || c == '\'') {
      i = end_of_string(toml, i);
    } else if (c == '#') {
      i = std::min(toml.find('\n', i), toml.size());
    } else {
      ++i;
    }
  }
  return std::nullopt;
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
  if (is_json(text)) return read_json_table(text, name, what);
  check_toml_nesting(text, name, what);
  if (const std::optional<TomlFault> fault = find_toml_fault(text)) {
    const std::string_view before = text.substr(0, fault->at);
    throw Error(ErrorKind::usage, "not a TOML " + what,
                fmt::format("{}:{}", name, std::count(before.begin(), before.end(), '\n') + 1),
                fault->why);
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
