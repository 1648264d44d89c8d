// Where a picture is taken from and how large it is: the same options for every verb.
#pragma once

#include <CLI/CLI.hpp>

#include "craze/render/picture.h"

namespace craze::app {

/// --width, --height, --samples, --azimuth, --elevation, --fov, --zoom, --at, in a group of that
/// name.
void add_camera_options(CLI::App& verb, render::PictureOptions& picture, const char* group);

}  // namespace craze::app
