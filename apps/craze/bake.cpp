// craze bake CRACKED: maps of a mesh that was cracked before.
#include <memory>

#include "app.h"
#include "craze/job/load_surface.h"
#include "craze/job/maps/bake_settings.h"
#include "craze/job/maps/write_maps.h"
#include "craze/job/output_folder.h"
#include "map_options.h"
#include "run_options.h"
#include "terminal/error_line.h"

namespace craze::app {

namespace {

struct BakeArguments {
  std::string input;
  MapsRequest maps;
  std::string gap, wall;
  std::vector<std::string> settings;
  RunOptions run;
};

/// --gap and --wall, then --set in order.
Recipe build_recipe(const BakeArguments& options) {
  Recipe recipe;
  if (!options.gap.empty()) apply_bake_set(recipe, "post.gap=" + options.gap);
  if (!options.wall.empty()) apply_bake_set(recipe, "post.wall=" + options.wall);
  for (const std::string& setting : options.settings) apply_bake_set(recipe, setting);
  return recipe;
}

int bake(BakeArguments& options) {
  const Recipe recipe = build_recipe(options);
  check_output_folder("the maps", options.maps.folder);
  const Run run(options.run);
  const Context& context = run.context();
  const MeshFile file = load_surface(options.input, context);
  options.maps.options.post = bake_post(recipe, file.mesh);
  for (const std::string& warning : write_maps(file.mesh, options.maps, context)) {
    print_warning(options.run.style, warning);
  }
  return done;
}

}  // namespace

void add_bake(CLI::App& app, Action& action) {
  const auto options = std::make_shared<BakeArguments>();
  CLI::App* verb = app.add_subcommand("bake", "Bake maps of a cracked mesh");
  verb->add_option("CRACKED", options->input,
                   "A mesh that craze crack wrote, with UVs and its cracks shut (post.gap=0)")
      ->required()
      ->type_name("FILE");
  verb->add_option("-o,--output", options->maps.folder, "The folder of the maps, made if need be")
      ->required()
      ->type_name("DIR");
  add_map_options(*verb, options->maps, "Maps");
  verb->add_option("--gap", options->gap,
                   "Width of the grooves over the cracks' opening: --set post.gap=X; 0: hairlines")
      ->type_name("X")
      ->group("Maps");
  verb->add_option("--wall", options->wall,
                   "Depth of the grooves: --set post.wall=LENGTH; 0: as deep as wide")
      ->type_name("LENGTH")
      ->group("Maps");
  verb->add_option("--set", options->settings,
                   "How grooves look, as often as you like: " + bake_keys())
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->group("Maps");
  add_run_options(*verb, options->run);
  verb->footer(
      "Examples:\n"
      "  craze bake cracked.ply -o maps --map normal --map mask --map-size 4096 --gap 0.05\n"
      "  craze bake cracked.ply -o maps --set post.gap_width=1mm --set post.late_width=0.3\n"
      "  craze bake cracked.glb -o maps --map-format exr --map-green down\n"
      "PLY knows the cracks' widths, times and pieces; OBJ and STL know where they run.");
  verb->callback([options, verb, &action] {
    check_needs(*verb, {green_need(options->maps)});
    action = [options] { return bake(*options); };
  });
}

}  // namespace craze::app
