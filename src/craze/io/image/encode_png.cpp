#include "craze/io/image/encode_png.h"

#include <array>
#include <cstdlib>
#include <limits>

#include "craze/io/image/deflate.h"
#include "craze/io/image/png_chunks.h"

namespace craze {

namespace {

enum Filter { none, left, up, average, paeth, filters };

/// What a filter expects of a byte, from those on the left, above, and above on the left.
std::uint8_t expected(int filter, int a, int b, int c) {
  const int pa = std::abs(b - c), pb = std::abs(a - c), pc = std::abs(a + b - 2 * c);
  switch (filter) {
    case left:
      return static_cast<std::uint8_t>(a);
    case up:
      return static_cast<std::uint8_t>(b);
    case average:
      return static_cast<std::uint8_t>((a + b) / 2);
    case paeth:
      return static_cast<std::uint8_t>(pa <= pb && pa <= pc ? a : pb <= pc ? b : c);
    default:
      return 0;
  }
}

/// Appends a row as differences, by the filter whose differences are the smallest in sum.
void append_row(const std::uint8_t* row, const std::uint8_t* above, std::size_t size,
                std::size_t pixel, std::string& bytes) {
  std::string best;
  long least = std::numeric_limits<long>::max();
  for (int filter = 0; filter < filters; ++filter) {
    std::string tried(1, static_cast<char>(filter));
    long sum = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const int a = i < pixel ? 0 : row[i - pixel];
      const int b = above ? above[i] : 0, c = above && i >= pixel ? above[i - pixel] : 0;
      const auto difference = static_cast<signed char>(row[i] - expected(filter, a, b, c));
      sum += std::abs(static_cast<int>(difference));
      tried += static_cast<char>(difference);
    }
    if (sum >= least) continue;
    least = sum;
    best = std::move(tried);
  }
  bytes += best;
}

}  // namespace

std::string encode_png(const Image& image) {
  constexpr std::array<char, 5> color_types{0, 0, 4, 2, 6};  // by channels
  const auto& values = std::get<std::vector<std::uint8_t>>(image.values);
  std::string header;
  put_big(header, static_cast<std::uint32_t>(image.width));
  put_big(header, static_cast<std::uint32_t>(image.height));
  header += {8, color_types[static_cast<std::size_t>(image.channels)], 0, 0, 0};
  const auto pixel = static_cast<std::size_t>(image.channels);
  const std::size_t size = pixel * static_cast<std::size_t>(image.width);
  std::string rows;
  rows.reserve((size + 1) * static_cast<std::size_t>(image.height));
  for (std::int32_t y = 0; y < image.height; ++y) {
    const std::uint8_t* row = values.data() + size * static_cast<std::size_t>(y);
    append_row(row, y > 0 ? row - size : nullptr, size, pixel, rows);
  }
  return std::string(png_signature) + png_chunk("IHDR", header) +
         png_chunk("IDAT", zlib_pack(rows)) + png_chunk("IEND", "");
}

}  // namespace craze
