// How a picture is taken: the same options for every verb.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "craze/length.h"
#include "craze/render/picture.h"
#include "option_needs.h"

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

/// What those options need: a picture, asked for by `needed`. `choice` must outlive it.
std::vector<OptionNeed> picture_needs(const CLI::App& verb, const PictureChoice& choice,
                                      const std::string& needed,
                                      const std::function<bool()>& takes_pictures);

}  // namespace craze::app
