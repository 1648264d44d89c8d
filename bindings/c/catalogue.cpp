// What there is: version, presets, parameters.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "craze/base/version.h"
#include "craze/presets.h"
#include "craze/recipe/parameter_table.h"
#include "craze/recipe/recipe_json.h"
#include "guard.h"

namespace craze::c {

char* copy_text(std::string_view text) {
  char* copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (!copy) throw std::bad_alloc();
  std::memcpy(copy, text.data(), text.size());
  copy[text.size()] = '\0';
  return copy;
}

}  // namespace craze::c

using namespace craze;
using namespace craze::c;

const char* craze_version(void) {
  return CRAZE_VERSION;
}

int craze_interface(void) {
  return CRAZE_INTERFACE;
}

void craze_text_free(char* text) {
  std::free(text);
}

char* craze_presets(craze_error* error) {
  return guarded(error, [] {
    auto all = nlohmann::ordered_json::object();
    for (const Preset& preset : presets()) {
      const std::string name(preset.name);
      all[name] = {{"description", preset.description()},
                   {"recipe", recipe_to_json(read_preset(name))}};
    }
    return copy_text(all.dump());
  });
}

char* craze_parameters(craze_error* error) {
  return guarded(error, [] { return copy_text(parameters_to_json().dump()); });
}
