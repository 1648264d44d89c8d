// craze render MESH: a picture of a mesh and of the cracks in it.
#include <memory>

#include "app.h"
#include "camera_options.h"
#include "craze/base/error.h"
#include "craze/render/png.h"
#include "craze/scenario/load_surface.h"
#include "craze/scenario/mesh_picture.h"
#include "craze/scenario/run.h"
#include "progress_line.h"

namespace craze::app {

namespace {

struct Options {
  std::string input, output, material = "clay";
  render::PictureOptions picture;
  int threads = 0;
  bool quiet = false;
};

int render_mesh(Options& options) {
  options.picture.material = render::find_material(options.material);
  check_picture_path(options.output);
  ProgressLine line(options.quiet);
  Context context;
  context.threads = options.threads;
  context.progress = [&](const Progress& progress) { line.update(progress); };
  const SurfaceMesh mesh = load_surface(options.input);
  render::write_png(options.output, mesh_picture(mesh, options.picture, context));
  return done;
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
  verb->add_option("--material", options->material, "clay, mud, glaze, plaster, glass or paint")
      ->type_name("NAME")
      ->capture_default_str();
  add_camera_options(*verb, options->picture, "Camera");
  verb->add_option("--threads", options->threads, "0: one per core")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  verb->add_flag("--quiet", options->quiet, "No progress");
  verb->footer(
      "Example:\n"
      "  craze render cracked.ply -o cracked.png --material glaze --azimuth 40");
  verb->callback([options, &action] { action = [options] { return render_mesh(*options); }; });
}

}  // namespace craze::app
