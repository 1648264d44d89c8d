// Is a value of the right type and in range? And the table as JSON.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "craze/base/text/format.h"
#include "craze/base/text/utf8.h"
#include "craze/error.h"
#include "craze/recipe/length_text.h"
#include "craze/recipe/nearest_name.h"
#include "craze/recipe/parameter_table.h"

namespace craze {

namespace {

bool has_type(const ParameterValue& value, ParameterType type) {
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  switch (type) {
    case ParameterType::real:
      return std::holds_alternative<double>(value);
    case ParameterType::integer:
      return std::holds_alternative<std::int64_t>(value);
    case ParameterType::boolean:
      return std::holds_alternative<bool>(value);
    case ParameterType::choice:
    case ParameterType::string:
      return std::holds_alternative<std::string>(value);
    case ParameterType::names:
      return std::holds_alternative<std::vector<std::string>>(value);
    case ParameterType::vec2:
      return numbers && (numbers->empty() || numbers->size() == 2);
    case ParameterType::vec3:
      return numbers && numbers->size() == 3;
    case ParameterType::tensor6:
      return numbers && numbers->size() == 6;
    case ParameterType::length:
    case ParameterType::edge:
      return std::holds_alternative<double>(value) || std::holds_alternative<std::string>(value);
  }
  return false;
}

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return text;
}

/// Enough of a UTF-8 text to know it again.
std::string shortened(const std::string& text) {
  std::size_t end = std::min<std::size_t>(text.size(), 40);
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + (end < text.size() ? "..." : "");
}

/// Ranges are doubles; what lies just beyond one that a double holds may round into it.
bool is_whole_in_double(std::int64_t x) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  return -most <= x && x <= most;
}

}  // namespace

void check_value(const Parameter& p, const ParameterValue& value, const std::string& key,
                 const std::string& where) {
  const auto fail = [&](const std::string& what, const std::string& why) {
    throw Error(ErrorKind::usage, what, where, why);
  };
  if (!has_type(value, p.type)) {
    fail("wrong type for " + key, fmt::format("must be {}", type_in_words(p.type)));
  }
  const auto check_number = [&](double x) {
    if (!std::isfinite(x))
      fail(key + " is not finite", "must be " + range_in_words(p.range, p.type));
    if (!p.range.contains(x)) {
      fail(fmt::format("{} = {} is out of range", key, x),
           "must be " + range_in_words(p.range, p.type));
    }
  };
  if (const auto* real = std::get_if<double>(&value)) check_number(*real);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    const auto x = static_cast<double>(*integer);
    check_number(x);
    if (!is_whole_in_double(*integer)) {
      fail(fmt::format("{} = {} is out of range", key, *integer),
           "must be " + range_in_words(p.range, p.type));
    }
  }
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    for (const double x : *numbers) check_number(x);
  }
  if (const auto* names = std::get_if<std::vector<std::string>>(&value)) {
    for (const std::string& name : *names) {
      if (!is_utf8(name)) fail(key + " is not text", "must be UTF-8");
    }
  }
  if (const auto* text = std::get_if<std::string>(&value)) {
    if (!is_utf8(*text)) fail(key + " is not text", "must be UTF-8");
    if (p.type == ParameterType::string) return;
    if (std::find(p.choices.begin(), p.choices.end(), *text) != p.choices.end()) return;
    if (p.is_length()) {
      if (const auto length = parse_length(*text)) return check_number(length->number());
    }
    if (p.type == ParameterType::length) {
      fail(key + " is not a length: " + format_value(shortened(*text)),
           "must be a number, or a number and right behind it one of " + join(length_suffixes()) +
               ", such as 4mm");
    }
    const std::string nearest = nearest_name(*text, p.choices);
    const std::string length = p.type == ParameterType::edge ? " or a length" : "";
    fail(fmt::format("{} has no choice {}", key, format_value(shortened(*text))),
         (nearest.empty() ? "" : "did you mean " + nearest + "? ") + "must be " + join(p.choices) +
             length);
  }
}

nlohmann::ordered_json parameters_to_json() {
  auto list = nlohmann::ordered_json::array();
  for (const Parameter& p : parameter_table()) {
    nlohmann::ordered_json entry{{"key", p.key},
                                 {"section", p.section()},
                                 {"name", p.name()},
                                 {"type", type_name(p.type)},
                                 {"default", value_to_json(p.default_value())}};
    if (std::isfinite(p.range.low)) entry["minimum"] = p.range.low;
    if (std::isfinite(p.range.high)) entry["maximum"] = p.range.high;
    if (p.range.low_open) entry["exclusive_minimum"] = true;
    if (!p.choices.empty()) entry["choices"] = p.choices;
    if (p.is_length()) entry["units"] = length_suffixes();
    entry["symbol"] = p.symbol;
    entry["unit"] = p.unit;
    entry["help"] = p.help;
    entry["source"] = p.source;
    entry["instead_of"] = p.instead_of;
    entry["repeated"] = p.repeated();
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace craze
