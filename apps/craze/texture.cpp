// craze texture PRESET: a tileable set of textures.
#include "craze/job/texture.h"

#include <memory>

#include "app.h"
#include "craze/error.h"
#include "craze/job/output_folder.h"
#include "craze/presets.h"
#include "map_options.h"
#include "run_options.h"

namespace craze::app {

namespace {

struct TextureArguments {
  TextureRequest request;
  std::string preset, period = "1", seed;
  std::vector<std::string> settings;
  RunOptions run;
};

int texture(TextureArguments& options) {
  TextureRequest& request = options.request;
  request.recipe = read_preset(options.preset);
  for (const std::string& setting : options.settings) apply_set(request.recipe, setting);
  if (!options.seed.empty()) apply_set(request.recipe, "seed=" + options.seed);
  request.tile = read_tile_size(options.period);
  check_output_folder("the textures", request.maps.folder);
  const Report report = make_texture(request, Run(options.run).context());
  print_warnings(options.run, report.warnings);
  return done;
}

}  // namespace

void add_texture(CLI::App& app, Action& action) {
  const auto options = std::make_shared<TextureArguments>();
  CLI::App* verb = app.add_subcommand("texture", "Make a tileable set of textures");
  verb->add_option("PRESET", options->preset, "A preset (craze presets)")
      ->required()
      ->type_name("");
  verb->add_option("-o,--output", options->request.maps.folder,
                   "The folder of the textures, made if need be")
      ->required()
      ->type_name("DIR");
  verb->add_option("--period", options->period,
                   "Side of the tile, model units or with a unit; relative lengths of the preset "
                   "are parts of its diagonal")
      ->type_name("LENGTH")
      ->capture_default_str();
  verb->add_option("--set", options->settings, "Change a parameter, as often as you like")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb->add_option("--seed", options->seed, "Another seed, another pattern")->type_name("N");
  verb->add_flag_callback(
      "--no-previews", [options] { options->request.previews = false; },
      "No preview_plane.png and preview_sphere.png");
  add_texture_map_options(*verb, options->request.maps, "Maps");
  add_run_options(*verb, options->run);
  verb->footer(
      "Examples:\n"
      "  craze texture mud -o mud --size 4096\n"
      "  craze texture glaze -o celadon --period 20cm --set layer.spacing=12mm --seed 7\n"
      "  craze texture paint -o paint --map base_color --map normal --map-green down\n"
      "The pattern has no border: tiles of one seed continue each other on every side.");
  verb->callback([options, verb, &action] {
    check_needs(*verb, {green_need(options->request.maps)});
    action = [options] { return texture(*options); };
  });
}

}  // namespace craze::app
