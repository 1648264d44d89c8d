#include "craze/engine/check_where.h"

#include <algorithm>

#include "craze/base/name_pattern.h"
#include "craze/error.h"
#include "craze/model/sources/input_fields.h"
#include "craze/recipe/nearest_name.h"

namespace craze {

namespace {

/// What one list of names is about.
struct Kind {
  const char* key;     ///< of the recipe
  const char* plural;  ///< of what has such names
};

/// The names that faces have, each once.
std::vector<std::string> used_names(const std::vector<std::int32_t>& index,
                                    const std::vector<std::string>& names) {
  std::vector<char> used(names.size(), 0);
  for (const std::int32_t i : index) {
    if (i >= 0 && static_cast<std::size_t>(i) < used.size()) used[i] = 1;
  }
  std::vector<std::string> list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (used[i]) list.push_back(names[i]);
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

/// "did you mean glass? the input's materials are glass, leather"
std::string what_there_is(const Kind& kind, const std::string& pattern,
                          const std::vector<std::string>& names) {
  if (names.empty()) return std::string("the input has no ") + kind.plural;
  const std::string nearest = nearest_name(pattern, names);
  return (nearest.empty() ? "" : "did you mean " + nearest + "? ") + "the input's " + kind.plural +
         " are " + listed(names);
}

void check_names(const Kind& kind, const std::vector<std::string>& patterns,
                 const std::vector<std::string>& names, std::vector<std::string>& warnings) {
  std::vector<std::string> missing;
  for (const std::string& pattern : patterns) {
    const bool found = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return fits_pattern(name, pattern);
    });
    if (!found) missing.push_back(pattern);
  }
  if (missing.empty()) return;
  if (missing.size() == patterns.size()) {
    throw Error(ErrorKind::request, "nothing is called " + missing.front(), kind.key,
                what_there_is(kind, missing.front(), names));
  }
  for (const std::string& pattern : missing) {
    warnings.push_back("nothing is called " + pattern + " (" + kind.key +
                       "): " + what_there_is(kind, pattern, names));
  }
}

}  // namespace

std::vector<std::string> check_where(const SurfaceMesh& surface, const WhereParameters& where) {
  std::vector<std::string> warnings;
  check_names({"where.materials", "materials"}, where.materials,
              used_names(surface.face_materials, surface.material_names), warnings);
  check_names({"where.nodes", "nodes"}, where.nodes,
              used_names(surface.face_objects, surface.object_names), warnings);
  if (!where.attribute.empty()) {
    const InputFields fields = input_fields(surface);
    std::vector<std::string> names;
    for (const auto* attributes : {&fields.vertex_attributes, &fields.face_attributes}) {
      for (const Attribute& a : *attributes) names.push_back(a.name);
    }
    if (std::find(names.begin(), names.end(), where.attribute) == names.end()) {
      throw Error(ErrorKind::request, "no attribute " + where.attribute, "where.attribute",
                  what_there_is({"where.attribute", "attributes"}, where.attribute, names));
    }
  }
  if (!where.texture.empty() && surface.corner_uvs.empty()) {
    throw Error(ErrorKind::request, "cannot use painted values", "where.texture",
                "the input has no texture coordinates (UVs), so a picture has no place on it");
  }
  return warnings;
}

}  // namespace craze
