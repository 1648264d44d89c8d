#include "craze/recipe/length_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include "craze/base/parse_double.h"
#include "craze/base/text/format.h"

namespace craze {

namespace {

struct Suffix {
  const char* text;
  double metres;
};

// In the order of LengthUnit, from micrometre on.
constexpr std::array<Suffix, 8> suffixes{{{"um", 1e-6},
                                          {"mm", 1e-3},
                                          {"cm", 1e-2},
                                          {"m", 1},
                                          {"km", 1e3},
                                          {"in", 0.0254},
                                          {"ft", 0.3048},
                                          {"%", 0}}};

std::optional<LengthUnit> find_unit(std::string_view suffix) {
  if (suffix.empty()) return LengthUnit::own;
  const auto* found = std::find_if(suffixes.begin(), suffixes.end(),
                                   [&](const Suffix& s) { return suffix == s.text; });
  if (found == suffixes.end()) return {};
  return static_cast<LengthUnit>(found - suffixes.begin() + 1);
}

/// Digits or a point, after a sign or none: what is read on may not be "inf" or "nan".
bool starts_a_number(std::string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  return !text.empty() && (text[0] == '.' || std::isdigit(static_cast<unsigned char>(text[0])));
}

}  // namespace

const std::vector<std::string>& length_suffixes() {
  static const std::vector<std::string> texts = [] {
    std::vector<std::string> list;
    for (const Suffix& s : suffixes) list.emplace_back(s.text);
    return list;
  }();
  return texts;
}

double metres(LengthUnit unit) {
  return unit == LengthUnit::own ? 0 : suffixes[static_cast<std::size_t>(unit) - 1].metres;
}

std::optional<Length> parse_length(std::string_view text) {
  if (!starts_a_number(text)) return {};
  if (text[0] == '+') text.remove_prefix(1);
  const char* end = text.data() + text.size();
  double number = 0;
  const auto [rest, status] = parse_double(text.data(), end, number);
  if (status == std::errc::invalid_argument) return {};
  if (status == std::errc::result_out_of_range) {
    number = std::strtod(std::string(text.data(), rest).c_str(), nullptr);  // ±huge, or tiny
  }
  const auto unit = find_unit({rest, static_cast<std::size_t>(end - rest)});
  if (!unit) return {};
  return Length(number, *unit);
}

std::string format_length(const Length& length) {
  const auto unit = static_cast<std::size_t>(length.unit());
  return fmt::format("{}{}", length.number(), unit == 0 ? "" : suffixes[unit - 1].text);
}

}  // namespace craze
