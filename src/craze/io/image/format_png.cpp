#include "craze/io/image/format_png.h"

#include <string_view>

#include "craze/io/image/deflate.h"
#include "craze/io/image/png_chunks.h"

namespace craze {

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
    rows += png_filter_left;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      rows += static_cast<char>(plain[i] - (i < pixel ? 0 : plain[i - pixel]));
    }
  }
  std::string header;
  put_big(header, static_cast<std::uint32_t>(p.width));
  put_big(header, static_cast<std::uint32_t>(p.height));
  header += {static_cast<char>(p.bits), static_cast<char>(p.channels == 3 ? 2 : 0), 0, 0, 0};
  std::string file(png_signature);
  file += png_chunk("IHDR", header);
  file += png_chunk("IDAT", zlib_pack(rows));
  file += png_chunk("IEND", "");
  return file;
}

}  // namespace craze
