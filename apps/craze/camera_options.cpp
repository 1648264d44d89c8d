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
  verb.add_option("--line-width", picture.line_width, "Of a crack, model units; 0: by the size")
      ->type_name("LENGTH")
      ->check(CLI::NonNegativeNumber)
      ->group(group);
}

}  // namespace craze::app
