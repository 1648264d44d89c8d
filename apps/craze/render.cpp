// craze render MESH: a picture of a mesh and of the cracks in it.
#include <map>
#include <memory>

#include "app.h"
#include "camera_options.h"
#include "craze/error.h"
#include "craze/job/load_surface.h"
#include "craze/job/run.h"
#include "craze/render/mesh_picture.h"
#include "craze/render/png.h"
#include "error_line.h"
#include "run_options.h"

namespace craze::app {

namespace {

struct Options {
  std::string input, output, material = "clay", background;
  render::PictureOptions picture;
  RunOptions run;
};

render::Rgb color_of(const std::string& text) {
  const bool hexadecimal =
      text.size() == 6 && text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
  if (!hexadecimal) {
    throw Error(ErrorKind::usage, "wrong colour", "--background " + text,
                "six hexadecimal digits are wanted, such as 606a78");
  }
  const int rgb = std::stoi(text, nullptr, 16);
  return render::from_srgb(rgb >> 16, rgb >> 8 & 255, rgb & 255);
}

int render_mesh(Options& options) {
  options.picture.material = render::find_material(options.material);
  if (!options.background.empty()) options.picture.backdrop = color_of(options.background);
  check_picture_path(options.output);
  const Run run(options.run);
  const Context& context = run.context();
  const MeshFile file = load_surface(options.input, context);
  for (const std::string& warning : file.warnings) print_warning(options.run.style, warning);
  render::write_png(options.output, mesh_picture(file.mesh, options.picture, context), context);
  return done;
}

void add_scene(CLI::App& verb, Options& options) {
  const char* group = "Scene";
  render::PictureOptions& picture = options.picture;
  const std::map<std::string, render::UpAxis> axes{{"auto", render::UpAxis::automatic},
                                                   {"x", render::UpAxis::x},
                                                   {"y", render::UpAxis::y},
                                                   {"z", render::UpAxis::z}};
  verb.add_option_function<std::string>(
          "--up", [&picture, axes](const std::string& axis) { picture.view.up = axes.at(axis); },
          "auto, x, y or z")
      ->check(CLI::IsMember({"auto", "x", "y", "z"}).description(""))
      ->type_name("AXIS")
      ->group(group);
  verb.add_option("--material", options.material, "clay, mud, glaze, plaster, glass or paint")
      ->type_name("NAME")
      ->capture_default_str()
      ->group(group);
  verb.add_option("--line-width", picture.line_width, "Of a crack, model units; 0: by the size")
      ->type_name("LENGTH")
      ->check(not_negative())
      ->group(group);
  verb.add_option("--light", picture.light.azimuth,
                  "Where the lamp stands: degrees to the right of the camera")
      ->type_name("DEG")
      ->group(group);
  verb.add_option("--light-elevation", picture.light.elevation, "Degrees above the horizon")
      ->type_name("DEG")
      ->check(CLI::Range(-90.0, 90.0))
      ->group(group);
  verb.add_option("--exposure", picture.exposure, "1: as it is, 2: twice as bright")
      ->type_name("X")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str()
      ->group(group);
  verb.add_flag_callback(
          "--no-ground", [&picture] { picture.ground = false; }, "No floor that catches the shadow")
      ->group(group);
  verb.add_option("--background", options.background, "A colour as RRGGBB; by the material")
      ->type_name("RRGGBB")
      ->group(group);
}

}  // namespace

void add_render(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("render", "Take a picture of a mesh and its cracks");
  verb->add_option("MESH", options->input, "A mesh file, or shape:NAME?key=value&...")
      ->required()
      ->type_name("");
  verb->add_option("-o,--output", options->output, "The picture: .png")
      ->required()
      ->type_name("FILE");
  add_camera_options(*verb, options->picture, "Camera");
  add_scene(*verb, *options);
  add_run_options(*verb, options->run);
  verb->footer(
      "Examples:\n"
      "  craze render cracked.ply -o cracked.png --material glaze --azimuth 40\n"
      "  craze render cracked.ply -o near.png --zoom 4 --at 0 0.1 0.2 --light -60 "
      "--light-elevation 20\n"
      "  craze render vase.glb -o vase.png --material glass --background 303840 --no-ground");
  verb->callback([options, &action] { action = [options] { return render_mesh(*options); }; });
}

}  // namespace craze::app
