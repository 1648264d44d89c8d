// How a picture is taken: the same options for every verb.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "craze/length.h"
#include "craze/render/picture.h"

namespace craze::app {

/// What the options leave. Material and upward axis may be a recipe's too; colours are the mesh's.
struct PictureChoice {
  render::PictureOptions picture;  ///< all but what is below
  Length line_width = 0;           ///< 0: by the size
  std::string material, up;        ///< as the recipe's keys take them; empty: not given
  bool plain = false;              ///< without the mesh's own colours
  std::string environment;         ///< a file; empty: not given
};

/// --width, --height, --samples, camera, material, light and background, in two groups.
void add_picture_options(CLI::App& verb, PictureChoice& choice);

}  // namespace craze::app
