#include "craze/recipe.h"

#include <nlohmann/json.hpp>

#include "craze/recipe/each_parameter.h"
#include "craze/recipe/recipe_json.h"

namespace craze {

bool operator==(const Recipe& a, const Recipe& b) {
  if (a.simulation.impacts.size() != b.simulation.impacts.size()) return false;
  bool equal = true;
  for_each_parameter(a, [&](const Parameter& p, std::size_t index, bool) {
    equal = equal && p.get(a, index) == p.get(b, index);
  });
  return equal;
}

std::string write_recipe(const Recipe& recipe) {
  std::string text;
  for_each_parameter(recipe, [&](const Parameter& p, std::size_t index, bool first) {
    const std::string section = p.section();
    if (first && !section.empty()) {
      text += p.repeated() ? "\n[[" + section + "]]\n" : "\n[" + section + "]\n";
    }
    text += p.name() + " = " + format_value(p.get(recipe, index)) + "\n";
  });
  return text;
}

nlohmann::ordered_json recipe_to_json(const Recipe& recipe) {
  nlohmann::ordered_json json;
  json["impact"] = nlohmann::ordered_json::array();
  for_each_parameter(recipe, [&](const Parameter& p, std::size_t index, bool first) {
    auto& section = p.section().empty() ? json : json[p.section()];
    if (first && p.repeated()) section.push_back(nlohmann::ordered_json::object());
    (p.repeated() ? section[index] : section)[p.name()] = value_to_json(p.get(recipe, index));
  });
  return json;
}

}  // namespace craze
