// craze presets [NAME]: what there is to choose from.
#include "craze/presets.h"

#include <memory>

#include "app.h"
#include "craze/base/text/format.h"

namespace craze::app {

void add_presets(CLI::App& app, Action& action) {
  const auto name = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("presets", "List the presets, or print one as a recipe");
  verb->add_option("NAME", *name, "Print this preset's TOML");
  verb->footer(
      "Examples:\n"
      "  craze presets\n"
      "  craze presets glaze > mine.toml");
  verb->callback([name, &action] {
    action = [name] {
      if (!name->empty()) return print(find_preset(*name).text);
      std::string text;
      for (const Preset& p : presets()) text += fmt::format("{:<12} {}\n", p.name, p.description());
      return print(text);
    };
  });
}

}  // namespace craze::app
