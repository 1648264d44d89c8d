// craze render MESH: a picture of a mesh and of the cracks in it.
#include <map>
#include <memory>

#include "app.h"
#include "craze/job/load_surface.h"
#include "craze/job/material_looks.h"
#include "craze/job/run.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/recipe/own_lengths.h"
#include "craze/render/light/environment_file.h"
#include "craze/render/mesh_picture.h"
#include "craze/render/png.h"
#include "picture_options.h"
#include "run_options.h"

namespace craze::app {

namespace {

struct RenderArguments {
  std::string input, output;
  PictureChoice choice;
  RunOptions run;
};

int render_mesh(RenderArguments& options) {
  const std::map<std::string, UpAxis> axes{{"", UpAxis::automatic},
                                           {"auto", UpAxis::automatic},
                                           {"x", UpAxis::x},
                                           {"y", UpAxis::y},
                                           {"z", UpAxis::z}};
  render::PictureOptions& picture = options.choice.picture;
  const std::string& material = options.choice.material;
  if (!material.empty()) picture.material = render::find_material(material);
  picture.view.up = axes.at(options.choice.up);
  check_picture_path(options.output);
  const Run run(options.run);
  const Context& context = run.context();
  if (const std::string& around = options.choice.environment; !around.empty()) {
    picture.environment.environment = render::read_environment(around, context);
  }
  MeshFile file = load_surface(options.input, context);
  const Yardstick yardstick{bounding_diagonal(file.mesh.positions), file.mesh.metres_per_unit};
  picture.line_width = own_length(options.choice.line_width, yardstick, "--line-width");
  if (!options.choice.plain) {
    picture.looks =
        material_looks(file.looks, options.input, file.warnings, context, ShownUvs::all);
    if (!picture.looks.empty()) picture.further_uvs = further_uvs(file, file.warnings);
  }
  render::write_png(options.output, mesh_picture(file.mesh, picture, context), context);
  print_warnings(options.run, file.warnings);
  return done;
}

}  // namespace

void add_render(CLI::App& app, Action& action) {
  const auto options = std::make_shared<RenderArguments>();
  CLI::App* verb = app.add_subcommand("render", "Take a picture of a mesh and its cracks");
  verb->add_option("MESH", options->input, "A mesh file, or shape:NAME?key=value&...")
      ->required()
      ->type_name("");
  verb->add_option("-o,--output", options->output, "The picture: .png")
      ->required()
      ->type_name("FILE");
  add_picture_options(*verb, options->choice);
  add_run_options(*verb, options->run);
  verb->footer(
      "Examples:\n"
      "  craze render cracked.ply -o cracked.png --material glaze --azimuth 40\n"
      "  craze render cracked.ply -o near.png --zoom 4 --at 0 0.1 0.2 --light -60 "
      "--light-elevation 20\n"
      "  craze render vase.glb -o vase.png --material glass --background 303840 --no-ground");
  verb->callback([verb, options, &action] {
    check_needs(*verb, picture_needs(*verb, options->choice, "-o", [] { return true; }));
    action = [options] { return render_mesh(*options); };
  });
}

}  // namespace craze::app
