// Eight bytes at a time: Kounavis and Berry, "Novel Table Lookup-Based Algorithms for
// High-Performance CRC Generation", IEEE Trans. Computers 57 (2008).
#include "craze/io/bytes/crc32.h"

#include <array>
#include <cstddef>

namespace craze {

namespace {

constexpr std::uint32_t reflected_polynomial = 0xEDB88320;
constexpr std::size_t at_once = 8;

using Table = std::array<std::uint32_t, 256>;

/// The k-th: what a byte does to the checksum k bytes after it.
constexpr std::array<Table, at_once> make_tables() {
  std::array<Table, at_once> tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t c = byte;
    for (int bit = 0; bit < 8; ++bit) c = c & 1 ? c >> 1 ^ reflected_polynomial : c >> 1;
    tables[0][byte] = c;
  }
  for (std::size_t k = 1; k < at_once; ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t c = tables[k - 1][byte];
      tables[k][byte] = c >> 8 ^ tables[0][c & 255];
    }
  }
  return tables;
}

constexpr std::array<Table, at_once> tables = make_tables();

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i]));
  };
  std::uint32_t c = 0xFFFFFFFF;
  std::size_t i = 0;
  for (; i + at_once <= bytes.size(); i += at_once) {
    c ^= byte(i) | byte(i + 1) << 8 | byte(i + 2) << 16 | byte(i + 3) << 24;
    c = tables[7][c & 255] ^ tables[6][c >> 8 & 255] ^ tables[5][c >> 16 & 255] ^
        tables[4][c >> 24] ^ tables[3][byte(i + 4)] ^ tables[2][byte(i + 5)] ^
        tables[1][byte(i + 6)] ^ tables[0][byte(i + 7)];
  }
  for (; i < bytes.size(); ++i) c = c >> 8 ^ tables[0][(c ^ byte(i)) & 255];
  return ~c;
}

}  // namespace craze
