#include "craze/presets.h"

#include "craze/error.h"
#include "craze/recipe/nearest_name.h"

namespace craze {

std::string_view Preset::description() const {
  const std::string_view line = text.substr(0, text.find('\n'));
  return line.substr(line.find_first_not_of("# "));
}

const Preset& find_preset(const std::string& name) {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) {
    if (preset.name == name) return preset;
    names.emplace_back(preset.name);
  }
  const std::string nearest = nearest_name(name, names);
  throw Error(ErrorKind::usage, "unknown preset", name,
              nearest.empty() ? "craze presets lists them" : "did you mean " + nearest + "?");
}

Recipe read_preset(const std::string& name) {
  return read_recipe(find_preset(name).text, "preset " + name);
}

}  // namespace craze
