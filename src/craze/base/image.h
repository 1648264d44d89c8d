// A picture in memory, with the numbers that its file has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "craze/grey_image.h"

namespace craze {

/// Rows from the top, pixels from the left, channels together: value c of pixel (x, y) is number
/// (y · width + x) · channels + c. Integers stand for 0 … 1 (255 or 65,535); floats are as they
/// are. Empty: not given.
struct Image {
  std::int32_t width = 0, height = 0;
  int channels = 1;  ///< 1 grey, 2 grey and alpha, 3 red green blue, 4 with alpha
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> values;

  bool empty() const { return width == 0 || height == 0; }
  /// Value c of pixel (x, y) as a number, integers scaled to 0 … 1.
  double value(std::int32_t x, std::int32_t y, int c) const;
};

/// Colours as 0.2126 R + 0.7152 G + 0.0722 B of the numbers as stored (no gamma), alpha ignored.
GreyImage to_grey(const Image& image);

}  // namespace craze
