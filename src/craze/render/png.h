// Pictures as PNG files.
#pragma once

#include <string>

#include "craze/context.h"
#include "craze/render/image.h"

namespace craze::render {

/// Writes beside `path` and renames, so no partial file is ever left. Throws Error(output) naming
/// the path, and Cancelled.
void write_png(const std::string& path, const Image& image, const Context& context = {});

}  // namespace craze::render
