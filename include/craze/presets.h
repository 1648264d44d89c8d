// Recipes that come with the library, under a name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "craze/recipe.h"

namespace craze {

struct Preset {
  std::string_view name;
  std::string_view text;  ///< TOML; its first line is "# " and the description
  std::string_view description() const;
};

/// All of them, by name: the files recipes/*.toml of the source tree, as they were when it was
/// built.
const std::vector<Preset>& presets();

/// One recipe per figure of the paper, by name: recipes/figures/*.toml, likewise (figure_table.h).
const std::vector<Preset>& figure_recipes();

/// The preset of that name; Error(usage) naming the nearest where there is none.
const Preset& find_preset(const std::string& name);

Recipe read_preset(const std::string& name);

}  // namespace craze
