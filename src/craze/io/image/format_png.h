// A picture as the bytes of a PNG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace craze {

/// What a PNG of integers is made of; rows from the top, pixels from the left, channels together.
struct PngPicture {
  int width = 0, height = 0;
  int channels = 1;                   ///< 1 grey, 3 red green blue
  int bits = 8;                       ///< 8 or 16
  std::vector<std::uint16_t> values;  ///< width · height · channels, each below 2^bits
};

/// ISO/IEC 15948:2004. Needs zlib (deflate.h).
std::string format_png(const PngPicture& picture);

}  // namespace craze
