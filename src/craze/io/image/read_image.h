// Grey pictures from PNG files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "craze/base/grey_image.h"

namespace craze {

/// A PNG of any kind as grey, 0 … 1 as stored: 8 or 16 bits, palette expanded, colours as
/// 0.2126 R + 0.7152 G + 0.0722 B, alpha ignored, no gamma. Throws Error(input) "cannot read
/// picture (PATH): WHY" for what is missing, damaged, not a PNG, or over 16,384 pixels wide or high
/// or 67 million in all.
GreyImage read_image(const std::filesystem::path& path);

/// The same from memory; `name` stands for the path in messages.
GreyImage decode_png(std::string_view bytes, const std::string& name);

}  // namespace craze
