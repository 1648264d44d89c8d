#include "picture_options.h"

#include "app.h"
#include "color_option.h"

namespace craze::app {

namespace {

constexpr const char *camera_group = "Camera of pictures", *scene_group = "Scene of pictures";

void add_camera(CLI::App& verb, PictureChoice& choice) {
  const char* group = camera_group;
  render::PictureOptions& picture = choice.picture;
  verb.add_option("--width", picture.width, "Pixels")
      ->type_name("N")
      ->check(CLI::Range(1, render::PictureOptions::largest_size))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--height", picture.height, "Pixels")
      ->type_name("N")
      ->check(CLI::Range(1, render::PictureOptions::largest_size))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--samples", picture.samples, "Per pixel")
      ->type_name("N")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--azimuth", picture.view.azimuth, "Degrees around the vertical")
      ->type_name("DEG")
      ->check(any_number())
      ->group(group);
  verb.add_option("--elevation", picture.view.elevation, "Degrees above the horizon")
      ->type_name("DEG")
      ->check(number_in(-90, 90))
      ->group(group);
  verb.add_option("--fov", picture.view.field_of_view,
                  "Vertical field of view; a wide one is nearer, so that all is still seen")
      ->type_name("DEG")
      ->check(number_in(1, 120))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--zoom", picture.view.zoom, "2: half as much is seen, twice as large")
      ->type_name("X")
      ->check(number_in(0.01, 1000))
      ->capture_default_str()
      ->group(group);
  verb.add_option_function<std::vector<double>>(
          "--at",
          [&picture](const std::vector<double>& p) {
            picture.view.target = Vec3(p[0], p[1], p[2]);
          },
          "The point in the middle of the picture")
      ->type_name("X Y Z")
      ->expected(3)
      ->group(group);
  verb.add_option("--aperture", picture.view.aperture,
                  "Of the lens, as a part of the object's size; what is out of focus blurs")
      ->type_name("X")
      ->check(number_in(0, 1))
      ->capture_default_str()
      ->group(group);
  verb.add_option_function<std::vector<double>>(
          "--focus",
          [&picture](const std::vector<double>& p) { picture.view.focus = Vec3(p[0], p[1], p[2]); },
          "The point that is sharp; by default what is in the middle of the picture")
      ->type_name("X Y Z")
      ->expected(3)
      ->group(group);
  verb.add_option("--up", choice.up, "auto, x, y or z")
      ->check(CLI::IsMember({"auto", "x", "y", "z"}).description(""))
      ->type_name("AXIS")
      ->group(group);
}

void add_scene(CLI::App& verb, PictureChoice& choice) {
  const char* group = scene_group;
  render::PictureOptions& picture = choice.picture;
  verb.add_option("--material", choice.material,
                  "What it looks like: clay, mud, glaze, plaster, glass or paint")
      ->type_name("NAME")
      ->group(group);
  verb.add_flag("--plain", choice.plain,
                "In the material's colours, not in the textures and colours of the mesh's own")
      ->group(group);
  add_length(verb, "--line-width", choice.line_width,
             "Of a crack, model units or with a unit; 0: by the size")
      ->group(group);
  CLI::Option* light = verb.add_option("--light", picture.light.azimuth,
                                       "Where the lamp stands: degrees to the right of the camera")
                           ->type_name("DEG")
                           ->check(any_number())
                           ->group(group);
  CLI::Option* environment =
      verb.add_option("--environment", choice.environment,
                      "Light from all around instead: an equirectangular .hdr, .png or .jpg")
          ->type_name("FILE")
          ->excludes(light)
          ->group(group);
  verb.add_option("--environment-turn", picture.environment.turn,
                  "Degrees to the right; 0: its middle is ahead of the camera")
      ->type_name("DEG")
      ->check(number_in(-360, 360))
      ->needs(environment)
      ->group(group);
  verb.add_option("--light-elevation", picture.light.elevation, "Degrees above the horizon")
      ->excludes(environment)
      ->type_name("DEG")
      ->check(number_in(-90, 90))
      ->group(group);
  verb.add_option("--exposure", picture.exposure, "1: as it is, 2: twice as bright")
      ->type_name("X")
      ->check(number_in(0.01, 100))
      ->capture_default_str()
      ->group(group);
  verb.add_flag_callback(
          "--no-ground", [&picture] { picture.ground = false; }, "No floor that catches the shadow")
      ->group(group);
  verb.add_option_function<std::string>(
          "--background",
          [&picture](const std::string& color) {
            const auto [r, g, b] = color_of("--background", color);
            picture.backdrop = render::from_srgb(r, g, b);
          },
          "A colour as RRGGBB; by the material")
      ->type_name("RRGGBB")
      ->group(group);
}

}  // namespace

void add_picture_options(CLI::App& verb, PictureChoice& choice) {
  add_camera(verb, choice);
  add_scene(verb, choice);
}

std::vector<OptionNeed> picture_needs(const CLI::App& verb, const PictureChoice& choice,
                                      const std::string& needed,
                                      const std::function<bool()>& takes_pictures) {
  std::vector<std::string> options = options_of_groups(verb, {camera_group, scene_group});
  // Which are keys of recipes too, and the first of files.
  std::erase_if(options,
                [](const std::string& name) { return name == "--up" || name == "--material"; });
  return {{options, needed, takes_pictures},
          {{"--focus"}, "--aperture", [&choice] { return choice.picture.view.aperture > 0; }}};
}

}  // namespace craze::app
