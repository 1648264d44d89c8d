#include "camera_options.h"

namespace craze::app {

void add_camera_options(CLI::App& verb, render::PictureOptions& picture, const char* group) {
  verb.add_option("--width", picture.width, "Pixels")
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
  verb.add_option("--height", picture.height, "Pixels")
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
  verb.add_option("--samples", picture.samples, "Per pixel")
      ->type_name("N")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--azimuth", picture.view.azimuth, "Degrees around the vertical")
      ->type_name("DEG")
      ->group(group);
  verb.add_option("--elevation", picture.view.elevation, "Degrees above the horizon")
      ->type_name("DEG")
      ->check(CLI::Range(-90.0, 90.0))
      ->group(group);
  verb.add_option("--fov", picture.view.field_of_view,
                  "Vertical field of view; a wide one is nearer, so that all is still seen")
      ->type_name("DEG")
      ->check(CLI::Range(1.0, 120.0))
      ->capture_default_str()
      ->group(group);
  verb.add_option("--zoom", picture.view.zoom, "2: half as much is seen, twice as large")
      ->type_name("X")
      ->check(CLI::Range(0.01, 1000.0))
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
}

}  // namespace craze::app
