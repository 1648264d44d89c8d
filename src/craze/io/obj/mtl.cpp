// Format: Alias/Wavefront, "MTL material format", Advanced Visualizer manual, appendix B2. Pr, Pm,
// Ke and norm: Exocortex, "Extending the OBJ-MTL format for PBR", 2013.
#include "craze/io/obj/mtl.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace craze {

namespace {

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool names_picture(const std::string& keyword) {
  return keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" ||
         keyword == "decal" || keyword == "refl" || keyword == "norm";
}

using Triple = std::array<double, 3>;

/// From CIE's XYZ to linear red, green and blue (IEC 61966-2-1).
Triple from_xyz(const Triple& c) {
  return {3.2406 * c[0] - 1.5372 * c[1] - 0.4986 * c[2],
          -0.9689 * c[0] + 1.8758 * c[1] + 0.0415 * c[2],
          0.0557 * c[0] - 0.2040 * c[1] + 1.0570 * c[2]};
}

/// "r g b", "xyz x y z"; numbers that are missing are the first.
std::optional<Triple> parse_color(std::string_view rest) {
  std::string_view ahead = rest;
  const bool is_xyz = lower(take_mtl_word(ahead)) == "xyz";
  if (is_xyz) rest = ahead;
  Triple color{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string_view word = take_mtl_word(rest);
    const bool ends = word.empty() || word.starts_with('#');
    const std::optional<double> number = ends && k > 0 ? color[0] : mtl_number(word);
    if (!number) return {};
    color[k] = *number;
  }
  return is_xyz ? from_xyz(color) : color;
}

/// Whether a line of that keyword changes nothing: the light that surrounds, which is the viewer's,
/// or numbers that are 0 (Tf: 1).
bool says_nothing(const std::string& keyword, std::string_view rest) {
  if (keyword.empty() || keyword.starts_with('#')) return true;
  // Ns is the width of the highlights that Ks makes.
  for (const char* of_light : {"ka", "ni", "ns", "illum", "sharpness"}) {
    if (keyword == of_light) return true;
  }
  const double nothing = keyword == "tf" ? 1 : 0;
  while (!rest.empty() && !rest.starts_with('#')) {
    if (mtl_number(take_mtl_word(rest)) != nothing) return false;
  }
  return true;
}

class Parser {
 public:
  std::vector<MtlMaterial> parse(std::string_view text) {
    for (const std::string& line : mtl_lines(text)) {
      std::string_view rest = line;
      const std::string_view word = take_mtl_word(rest);
      const std::string keyword = lower(word);
      if (keyword == "newmtl") {
        materials_.emplace_back().name = std::string(rest);
        has_opacity_ = false;
      } else if (!materials_.empty() && !add(materials_.back(), keyword, rest) &&
                 !says_nothing(keyword, rest)) {
        add_other(std::string(word));
      }
    }
    return std::move(materials_);
  }

 private:
  /// False for a keyword that is not known.
  bool add(MtlMaterial& material, const std::string& keyword, std::string_view rest) {
    if (keyword == "kd" || keyword == "ke") {
      add_color(material, keyword == "ke", rest);
    } else if (keyword == "d" || keyword == "tr") {
      add_opacity(material, keyword == "d", rest);
    } else if (keyword == "pr" || keyword == "pm") {
      double& value = keyword == "pr" ? material.roughness : material.metallic;
      value = bounded(material, mtl_number(take_mtl_word(rest)).value_or(value));
    } else if (keyword == "map_kd") {
      material.color_picture = parse_mtl_picture(rest);
    } else if (keyword == "map_ke") {
      material.emission_picture = parse_mtl_picture(rest);
      if (material.emission == Triple{0, 0, 0}) material.emission = {1, 1, 1};
    } else if (keyword == "norm") {
      material.normal_picture = parse_mtl_picture(rest);
    } else {
      return false;
    }
    return true;
  }

  static double bounded(MtlMaterial& material, double value, double most = 1) {
    const double inside = std::clamp(value, 0.0, most);
    material.is_bounded |= inside != value;
    return inside;
  }

  static void add_color(MtlMaterial& material, bool emits, std::string_view rest) {
    constexpr double brightest = 1e6;
    const std::optional<Triple> color = parse_color(rest);
    if (!color) {
      material.has_unknown_color = true;
      return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      (emits ? material.emission : material.color)[k] =
          bounded(material, (*color)[k], emits ? brightest : 1);
    }
  }

  /// Writers that disagree on Tr give d as well.
  void add_opacity(MtlMaterial& material, bool is_d, std::string_view rest) {
    std::string_view word = take_mtl_word(rest);
    if (word == "-halo") word = take_mtl_word(rest);
    const std::optional<double> number = mtl_number(word);
    if (!number || (!is_d && has_opacity_)) return;
    const double value = bounded(material, *number);
    material.opacity = is_d ? value : 1 - value;
    has_opacity_ |= is_d;
  }

  void add_other(std::string keyword) {
    constexpr std::size_t most = 64;
    auto& others = materials_.back().others;
    const bool is_known = std::find(others.begin(), others.end(), keyword) != others.end();
    if (!is_known && others.size() < most) others.push_back(std::move(keyword));
  }

  std::vector<MtlMaterial> materials_;
  bool has_opacity_ = false;
};

}  // namespace

std::vector<MtlMaterial> parse_mtl(std::string_view text) {
  return Parser().parse(text);
}

std::string one_line_name(std::string name) {
  for (char& c : name) {
    if (c == '\n' || c == '\r' || c == '\t') c = '_';
  }
  if (name.ends_with('\\')) name.back() = '_';
  return name;
}

std::vector<std::string> mtl_names(const SurfaceMesh& mesh) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const std::string& given : mesh.material_names) {
    std::string name = one_line_name(given);
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
  for (const std::string& line : mtl_lines(text)) {
    std::string_view rest = line;
    const std::string keyword = lower(take_mtl_word(rest));
    const std::string_view name = names_picture(keyword) ? mtl_picture_name(rest) : "";
    if (name.empty()) {
      result += line;
    } else {
      result += line.substr(0, static_cast<std::size_t>(name.data() - line.data()));
      result += rename(std::string(name));
    }
    result += '\n';
  }
  return result;
}

}  // namespace craze
