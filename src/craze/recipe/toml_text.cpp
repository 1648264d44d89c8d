#include "craze/recipe/toml_text.h"

#include <fmt/format.h>

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

}  // namespace

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
