// Format: Alias/Wavefront, "MTL material format", Advanced Visualizer manual, appendix B2.
#include "craze/io/obj/mtl.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

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

/// What follows the options of a picture's line, each of which is shown: visit(option, index of the
/// argument, argument).
template <class Visit>
std::string_view picture_name(std::string_view rest, Visit visit) {
  while (rest.starts_with('-')) {
    const std::string_view option = take_word(rest);
    const bool is_vector = option == "-o" || option == "-s" || option == "-t";
    const int arguments = is_vector ? 3 : option == "-mm" ? 2 : 1;
    for (int i = 0; i < arguments; ++i) {
      std::string_view ahead = rest;
      const std::string_view word = take_word(ahead);
      if (is_vector && !is_number(word)) break;
      visit(option, static_cast<std::size_t>(i), word);
      rest = ahead;
    }
  }
  return rest;
}

std::string_view picture_name(std::string_view rest) {
  return picture_name(rest, [](std::string_view, std::size_t, std::string_view) {});
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

double any_number(std::string_view word) {
  const double value = std::strtod(std::string(word).c_str(), nullptr);
  return std::isfinite(value) ? value : 0;
}

double number_or(std::string_view word, double fallback) {
  return is_number(word) ? std::clamp(std::strtod(std::string(word).c_str(), nullptr), 0.0, 1.0)
                         : fallback;
}

}  // namespace

std::vector<MtlMaterial> parse_mtl(std::string_view text) {
  std::vector<MtlMaterial> materials;
  bool has_opacity = false;
  for_each_line(text, [&](std::string_view line) {
    std::string_view rest = line;
    const std::string_view keyword = take_word(rest);
    if (keyword == "newmtl") {
      materials.emplace_back().name = std::string(rest);
      has_opacity = false;
    } else if (!materials.empty()) {
      MtlMaterial& material = materials.back();
      if (keyword == "Kd") {
        for (double& channel : material.color) channel = number_or(take_word(rest), channel);
      } else if (keyword == "d" || keyword == "Tr") {
        const double value =
            std::clamp(number_or(take_word(rest), keyword == "d" ? 1 : 0), 0.0, 1.0);
        // Writers that disagree on Tr give d as well.
        if (keyword == "d") {
          material.opacity = value;
          has_opacity = true;
        } else if (!has_opacity) {
          material.opacity = 1 - value;
        }
      } else if (keyword == "map_Kd") {
        material.scale = {1, 1};
        material.shift = {0, 0};
        material.is_clamped = false;
        const auto place = [&](std::string_view option, std::size_t i, std::string_view word) {
          if (option == "-clamp") material.is_clamped = word == "on";
          if (i > 1 || (option != "-s" && option != "-o")) return;
          (option == "-s" ? material.scale : material.shift)[i] = any_number(word);
        };
        material.color_picture = std::string(picture_name(rest, place));
      }
    }
  });
  return materials;
}

std::vector<std::string> mtl_names(const SurfaceMesh& mesh) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const std::string& given : mesh.material_names) {
    std::string name = given;
    for (char& c : name) {
      if (c == '\n' || c == '\r' || c == '\t') c = '_';
    }
    if (name.empty()) name = "material_" + std::to_string(names.size());
    const std::string wanted = name;
    for (int n = 2; !taken.insert(name).second; ++n) name = wanted + "_" + std::to_string(n);
    names.push_back(std::move(name));
  }
  return names;
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
