// Format: Alias/Wavefront, "MTL material format", Advanced Visualizer manual, appendix B2.
#include "craze/io/obj/mtl.h"

#include <algorithm>
#include <cstdlib>

namespace craze {

namespace {

constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

/// Takes the first word off a text.
std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

bool is_number(std::string_view word) {
  const std::string text(word);
  char* end = nullptr;
  static_cast<void>(std::strtod(text.c_str(), &end));
  return !text.empty() && *end == '\0';
}

/// What follows the options of a picture's line.
std::string_view picture_name(std::string_view rest) {
  while (rest.starts_with('-')) {
    const std::string_view option = take_word(rest);
    const bool is_vector = option == "-o" || option == "-s" || option == "-t";
    int arguments = is_vector ? 3 : option == "-mm" ? 2 : 1;
    while (arguments-- > 0) {
      std::string_view ahead = rest;
      const std::string_view word = take_word(ahead);
      if (is_vector && !is_number(word)) break;
      rest = ahead;
    }
  }
  return rest;
}

bool names_picture(std::string_view keyword) {
  return keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" ||
         keyword == "decal" || keyword == "refl" || keyword == "norm";
}

template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    visit(text.substr(0, end));
    text = text.substr(std::min(end + 1, text.size()));
  }
}

double number_or(std::string_view word, double fallback) {
  return is_number(word) ? std::clamp(std::strtod(std::string(word).c_str(), nullptr), 0.0, 1.0)
                         : fallback;
}

}  // namespace

std::vector<MtlMaterial> parse_mtl(std::string_view text) {
  std::vector<MtlMaterial> materials;
  for_each_line(text, [&](std::string_view line) {
    std::string_view rest = line;
    const std::string_view keyword = take_word(rest);
    if (keyword == "newmtl") {
      materials.emplace_back().name = std::string(rest);
    } else if (!materials.empty()) {
      MtlMaterial& material = materials.back();
      if (keyword == "Kd") {
        for (double& channel : material.color) channel = number_or(take_word(rest), channel);
      } else if (keyword == "d" || keyword == "Tr") {
        const double value = number_or(take_word(rest), keyword == "d" ? 1 : 0);
        material.opacity = keyword == "d" ? value : 1 - value;
      } else if (keyword == "map_Kd") {
        material.color_picture = std::string(picture_name(rest));
      }
    }
  });
  return materials;
}

std::string rename_pictures(std::string_view text,
                            const std::function<std::string(const std::string&)>& rename) {
  std::string result;
  for_each_line(text, [&](std::string_view line) {
    std::string_view rest = line;
    const std::string_view keyword = take_word(rest);
    const std::string_view name = names_picture(keyword) ? picture_name(rest) : "";
    if (name.empty()) {
      result += line;
    } else {
      result += line.substr(0, static_cast<std::size_t>(name.data() - line.data()));
      result += rename(std::string(name));
    }
    result += '\n';
  });
  return result;
}

}  // namespace craze
