#include "craze/io/image/format_png.h"

#include <string_view>

#include "craze/io/image/deflate.h"

namespace craze {

namespace {

/// Each row is its difference from the pixel on the left.
constexpr char filter_left = 1;

void put_big(std::string& bytes, std::uint32_t x) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(x >> shift & 255);
}

void put_chunk(std::string& file, std::string_view type, std::string_view data) {
  put_big(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = file.size();
  file += type;
  file += data;
  put_big(file, crc(std::string_view(file).substr(begin)));
}

}  // namespace

std::string format_png(const PngPicture& p) {
  const std::size_t bytes_of_value = static_cast<std::size_t>(p.bits / 8);
  const std::size_t row_values = static_cast<std::size_t>(p.width) * p.channels;
  const std::size_t pixel = bytes_of_value * p.channels;
  std::string rows, plain(row_values * bytes_of_value, '\0');
  rows.reserve((plain.size() + 1) * p.height);
  for (int y = 0; y < p.height; ++y) {
    const std::uint16_t* in = p.values.data() + row_values * y;
    for (std::size_t i = 0; i < row_values; ++i) {
      if (p.bits == 16) plain[2 * i] = static_cast<char>(in[i] >> 8);
      plain[bytes_of_value * (i + 1) - 1] = static_cast<char>(in[i] & 255);
    }
    rows += filter_left;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      rows += static_cast<char>(plain[i] - (i < pixel ? 0 : plain[i - pixel]));
    }
  }
  std::string file = "\x89PNG\r\n\x1a\n", header;
  put_big(header, static_cast<std::uint32_t>(p.width));
  put_big(header, static_cast<std::uint32_t>(p.height));
  header += {static_cast<char>(p.bits), static_cast<char>(p.channels == 3 ? 2 : 0), 0, 0, 0};
  put_chunk(file, "IHDR", header);
  put_chunk(file, "IDAT", zlib_pack(rows));
  put_chunk(file, "IEND", "");
  return file;
}

}  // namespace craze
