// What JPEG makes of a picture.
#pragma once

#include <cstdint>
#include <vector>

namespace craze {

/// Packs and unpacks sRGB, three bytes a pixel, rows from the top; quality 1 … 100. Throws
/// Error(request) where the build has no JPEG.
void jpeg_round_trip(int width, int height, std::vector<std::uint8_t>& rgb, int quality);

}  // namespace craze
