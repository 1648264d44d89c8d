// craze crack INPUT: grows cracks on a mesh and writes what was asked for.
#include <filesystem>
#include <memory>

#include "app.h"
#include "craze/job/run.h"
#include "craze/presets.h"
#include "map_options.h"
#include "picture_options.h"
#include "run_options.h"
#include "terminal/interrupt.h"

namespace craze::app {

namespace {

struct CrackArguments {
  RunRequest request;
  std::string preset, recipe, seed;
  PictureChoice choice;
  std::vector<std::string> settings;
  RunOptions run;
};

// What a bare `craze crack INPUT -o OUT` makes.
constexpr const char* standard_preset = "glaze";

/// The preset or recipe file, else the defaults where keys are set by hand, else the standard
/// preset; then --set in order, then --seed.
Recipe build_recipe(CrackArguments& options) {
  Recipe recipe;
  if (!options.preset.empty()) {
    recipe = read_preset(options.preset);
  } else if (options.recipe.empty() && options.settings.empty()) {
    recipe = read_preset(standard_preset);
  }
  if (!options.recipe.empty()) {
    recipe = read_recipe_file(options.recipe);
    const std::filesystem::path folder = std::filesystem::path(options.recipe).parent_path();
    options.request.textures = texture_folder(folder, recipe);
  }
  for (const std::string& setting : options.settings) apply_set(recipe, setting);
  const std::string &material = options.choice.material, &up = options.choice.up;
  if (!material.empty()) apply_set(recipe, "picture.material=\"" + material + "\"");
  if (!up.empty()) apply_set(recipe, "picture.up=\"" + up + "\"");
  if (!options.seed.empty()) apply_set(recipe, "seed=" + options.seed);
  return recipe;
}

int crack(CrackArguments& options) {
  options.request.recipe = build_recipe(options);
  options.request.shot = options.choice.picture;
  options.request.line_width = options.choice.line_width;
  options.request.plain = options.choice.plain;
  options.request.environment = options.choice.environment;
  check_request(options.request);
  const RunResult result = run(options.request, Run(options.run).context());
  print_warnings(options.run, result.report.warnings);
  int code = done;
  if (options.request.report == "-") code = print(result.report_text);
  return result.cancelled ? interrupt_code() : code;
}

/// Which options do nothing without which.
std::vector<OptionNeed> needs_of(const CLI::App& verb, const CrackArguments& options) {
  const RunRequest& request = options.request;
  const auto maps = [&request] { return !request.maps.folder.empty(); };
  const auto mapped = [&request] { return request.as_maps; };
  const auto animated = [&request] { return request.animate; };
  const auto video = [&request] { return !request.video.empty(); };
  const auto frames = [&request] { return !request.frames.empty(); };
  std::vector<OptionNeed> needs =
      picture_needs(verb, options.choice, "--picture, --frames (.png) or --video",
                    [&request] { return takes_pictures(request); });
  needs.insert(needs.end(),
               {{{"--map", "--map-format", "--map-green"}, "--maps", maps},
                {{"--map-size"}, "--maps or --as maps", [=] { return maps() || mapped(); }},
                {{"--stain"}, "--as maps", mapped},
                {{"--stages"}, "--animate", animated},
                {{"--seconds"}, "--animate or --video", [=] { return animated() || video(); }},
                {{"--frame-count"}, "--frames or --video", [=] { return frames() || video(); }},
                {{"--frame-format"}, "--frames", frames},
                green_need(request.maps)});
  return needs;
}

void add_outputs(CLI::App& verb, RunRequest& request) {
  const char* group = "Outputs";
  verb.add_option("-o,--output", request.output,
                  "The cracked mesh: .ply, .obj, .stl, .glb or .usda")
      ->type_name("FILE")
      ->group(group);
  verb.add_option_function<std::string>(
          "--as", [&request](const std::string& as) { request.as_maps = as == "maps"; },
          "mesh: -o is cut; maps: -o, .glb, is the input as it is, with the cracks in its "
          "materials' textures")
      ->check(CLI::IsMember({"mesh", "maps"}).description(""))
      ->type_name("WHAT")
      ->default_str("mesh")
      ->group(group);
  verb.add_option("--lines", request.lines, "The cracks as lines: .ply, .obj, .svg or .json")
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--picture", request.picture, "A picture: .png")->type_name("FILE")->group(group);
  verb.add_flag("--fragments", request.split_fragments,
                "In -o, .obj, .glb or .usda: each fragment an object of its own")
      ->group(group);
  verb.add_option("--report", request.report, "What was done, as JSON; -: to standard output")
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--maps", request.maps.folder,
                  "Textures of the cracks for the mesh's own UVs, into this folder")
      ->type_name("DIR")
      ->group(group);
  verb.add_option("--fields", request.fields, "Stress, forces and curvatures at the end: .ply")
      ->type_name("FILE")
      ->group(group);
}

void add_growth(CLI::App& verb, RunRequest& request) {
  const char* group = "Growth";
  verb.add_flag("--animate", request.animate,
                "In -o, .glb or .usda: the cracks open one after the other, in any viewer; needs "
                "post.gap")
      ->group(group);
  verb.add_option("--stages", request.animation_stages,
                  "Morph targets of --animate; some old viewers know only 8")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--frames", request.frames, "One file per moment: DIR/frame_0000.png ...")
      ->type_name("DIR")
      ->group(group);
  verb.add_option("--frame-count", request.frame_count, "How many frames")
      ->type_name("N")
      ->check(CLI::Range(1, 9999))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--frame-format", request.frame_format,
                  "png: pictures; ply, obj, stl or glb: meshes, all with the same triangles")
      ->type_name("EXT")
      ->capture_default_str()
      ->group(group);
  verb.add_option("--video", request.video, "The frames as a video, .mp4 or .webm; needs ffmpeg")
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--seconds", request.clip_seconds, "Length of --animate and --video")
      ->type_name("S")
      ->check(number_in(0.1, 3600))
      ->capture_default_str()
      ->group(group);
}

}  // namespace

void add_crack(CLI::App& app, Action& action) {
  const auto options = std::make_shared<CrackArguments>();
  CLI::App* verb = app.add_subcommand("crack", "Grow cracks on a mesh");
  verb->add_option("INPUT", options->request.input,
                   "A mesh (.obj .ply .stl .off .gltf .glb), or shape:NAME?key=value&...")
      ->required()
      ->type_name("");
  add_outputs(*verb, options->request);
  add_growth(*verb, options->request);
  add_map_options(*verb, options->request.maps, "Maps (--maps, --as maps)");
  add_stain_option(*verb, options->request.stain, "Maps (--maps, --as maps)");
  add_picture_options(*verb, options->choice);
  CLI::Option* preset = verb->add_option(
      "--preset", options->preset, "See craze presets; glaze where no recipe and no key is given");
  preset->type_name("NAME");
  verb->add_option("--recipe", options->recipe, "A recipe of your own, TOML")
      ->type_name("FILE")
      ->excludes(preset);
  verb->add_option("--set", options->settings,
                   "Change one key of the recipe, as often as you like; see craze parameters")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb->add_option("--seed", options->seed, "The same as --set seed=N")->type_name("N");
  verb->add_option("--max-cracks", options->request.max_cracks,
                   "Stop after N crack events; 0: before the first")
      ->type_name("N")
      ->check(not_negative());
  add_run_options(*verb, options->run);
  verb->footer(
      "Examples:\n"
      "  craze crack cup.obj -o cracked.glb --preset glaze\n"
      "  craze crack shape:plate?n=99 -o mud.ply --preset mud --lines mud.svg --report mud.json\n"
      "  craze crack vase.glb -o cracked.glb --preset glaze --set layer.spacing=4mm --set "
      "where.materials=glaze*\n"
      "  craze crack scan.ply -o scan_cracked.ply --preset mud --set stress.attribute=paint\n"
      "  craze crack shape:plate -o grow.glb --preset mud --set post.gap=0.08 --set post.wall=0.02 "
      "--animate\n"
      "  craze crack shape:cup --video grow.mp4 --frame-count 96\n"
      "  craze crack vase.obj -o pieces.glb --fragments\n"
      "  craze crack vase.glb -o cracked.glb --as maps --preset glaze --stain 3b2314\n"
      "  craze crack vase.obj --maps vase_maps --map normal --map occlusion --map-size 2048\n"
      "Ctrl-C stops, writes what was asked for and exits with 130 (SIGTERM: 143); a second one "
      "kills.");
  verb->callback([verb, options, &action] {
    check_needs(*verb, needs_of(*verb, *options));
    action = [options] { return crack(*options); };
  });
}

}  // namespace craze::app
