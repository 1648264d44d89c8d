// The parts of a PNG file; ISO/IEC 15948:2004.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "craze/io/bytes/crc32.h"

namespace craze {

inline constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// Each row is its difference from the pixel on the left, which needs no other row.
inline constexpr char png_filter_left = 1;

/// The most significant byte first.
inline void put_big(std::string& bytes, std::uint32_t x) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(x >> shift & 255);
}

/// Length, type of four letters, data and checksum.
inline std::string png_chunk(std::string_view type, std::string_view data) {
  std::string chunk;
  put_big(chunk, static_cast<std::uint32_t>(data.size()));
  chunk += type;
  chunk += data;
  put_big(chunk, crc32(std::string_view(chunk).substr(4)));
  return chunk;
}

}  // namespace craze
