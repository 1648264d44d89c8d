#include "craze/io/obj/mtl_lines.h"

#include <algorithm>
#include <cmath>

#include "craze/base/parse_double.h"
#include "craze/io/files/file_names.h"

namespace craze {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(blanks);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(blanks) - from + 1);
}

/// What follows the options of a picture's line, each of which is shown: visit(option, index of the
/// argument, argument).
template <class Visit>
std::string_view after_options(std::string_view rest, Visit visit) {
  rest = trimmed(rest);
  while (rest.starts_with('-')) {
    const std::string_view option = take_mtl_word(rest);
    const bool is_vector = option == "-o" || option == "-s" || option == "-t";
    const int arguments = is_vector ? 3 : option == "-mm" ? 2 : 1;
    for (int i = 0; i < arguments; ++i) {
      std::string_view ahead = rest;
      const std::string_view word = take_mtl_word(ahead);
      if (is_vector && !mtl_number(word)) break;
      visit(option, static_cast<std::size_t>(i), word);
      rest = ahead;
    }
  }
  return rest;
}

}  // namespace

std::vector<std::string> mtl_lines(std::string_view text) {
  std::vector<std::string> lines;
  bool joins = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    if (text.starts_with("\r\n")) text.remove_prefix(1);
    if (!text.empty()) text.remove_prefix(1);
    const bool joins_next = line.ends_with('\\');
    if (joins_next) line.remove_suffix(1);
    if (joins) {
      lines.back() += ' ';
      lines.back() += line;
    } else {
      lines.emplace_back(line);
    }
    joins = joins_next;
  }
  return lines;
}

std::string_view take_mtl_word(std::string_view& text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

std::optional<double> mtl_number(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [last, status] = parse_double(word.data(), end, value);
  if (word.empty() || status != std::errc{} || last != end || !std::isfinite(value)) return {};
  return value;
}

MtlPicture parse_mtl_picture(std::string_view rest) {
  MtlPicture picture;
  const auto read = [&](std::string_view option, std::size_t i, std::string_view word) {
    const double number = mtl_number(word).value_or(0);
    if (option == "-clamp") picture.is_clamped = word == "on";
    if (option == "-bm") picture.strength = number;
    if (i > 1) return;
    if (option == "-s") picture.scale[i] = number;
    if (option == "-o") picture.shift[i] = number;
  };
  picture.name = plain_file_name(after_options(rest, read));
  return picture;
}

std::string_view mtl_picture_name(std::string_view rest) {
  return after_options(rest, [](std::string_view, std::size_t, std::string_view) {});
}

}  // namespace craze
