// craze parameters: every key of a recipe.
#include <memory>
#include <nlohmann/json.hpp>

#include "app.h"
#include "craze/recipe/parameter_reference.h"
#include "craze/recipe/parameter_table.h"

namespace craze::app {

void add_parameters(CLI::App& app, Action& action) {
  struct Options {
    bool json = false, markdown = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("parameters", "List every key of a recipe");
  CLI::Option* json = verb->add_flag("--json", options->json, "As JSON, for other programs");
  verb->add_flag("--markdown", options->markdown, "As the page docs/reference.md")->excludes(json);
  verb->callback([options, &action] {
    action = [options] {
      if (options->json) return print(parameters_to_json().dump(2) + "\n");
      return print(options->markdown ? parameter_page() : parameter_listing());
    };
  });
}

}  // namespace craze::app
