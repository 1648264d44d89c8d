#include "craze/output/named_nodes.h"

#include <algorithm>

#include "craze/base/name_pattern.h"
#include "craze/io/source_scene.h"

namespace craze {

Recipe with_named_nodes(Recipe recipe, const SurfaceMesh& surface, const SourceScene* scene) {
  std::vector<std::string>& patterns = recipe.simulation.where.nodes;
  if (patterns.empty() || !scene) return recipe;
  const std::vector<OtherName> others = scene->other_names();
  std::vector<std::string> spelt;
  const auto add = [&](const std::string& name) {
    if (std::find(spelt.begin(), spelt.end(), name) == spelt.end()) spelt.push_back(name);
  };
  for (const std::string& pattern : patterns) {
    const auto& nodes = surface.object_names;
    const bool is_own = std::any_of(nodes.begin(), nodes.end(), [&](const std::string& name) {
      return fits_pattern(name, pattern);
    });
    bool is_other = false;
    for (const OtherName& other : others) {
      if (!fits_pattern(other.name, pattern) || fits_pattern(other.object, pattern)) continue;
      is_other = true;
      add(other.object);
    }
    if (is_own || !is_other) add(pattern);
  }
  patterns = std::move(spelt);
  return recipe;
}

}  // namespace craze
