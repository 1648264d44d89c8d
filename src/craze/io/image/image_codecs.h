// The formats of pictures. Each is one file that alone knows its library, which a build may lack:
// then the format is refused, by name.
#pragma once

#include <string>
#include <string_view>

#include "craze/base/image.h"

namespace craze {

/// By the first bytes, whatever libraries there are.
bool is_png(std::string_view bytes);
bool is_jpeg(std::string_view bytes);

/// The picture as read_image() promises it.
Image decode_png(std::string_view bytes, const std::string& name);
Image decode_jpeg(std::string_view bytes, const std::string& name);

}  // namespace craze
