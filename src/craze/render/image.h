// A finished picture.
#pragma once

#include <cstdint>
#include <vector>

namespace craze::render {

/// 8-bit sRGB, three bytes a pixel, rows from the top, without padding.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

}  // namespace craze::render
