// Radiance's pictures, whose pixels share an exponent.
#pragma once

#include <string>
#include <string_view>

#include "craze/base/image.h"

namespace craze::render {

/// Linear red, green and blue of a .hdr file, rows from the top, in any of its three ways to pack
/// pixels. `name` is for messages. Throws Error(input) where the bytes are something else, end too
/// early, or hold XYZ or rows and columns in another order than -Y +X.
craze::Image read_radiance_picture(std::string_view bytes, const std::string& name);

}  // namespace craze::render
