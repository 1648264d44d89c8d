#include "craze/io/bytes/crc32.h"

#include <gtest/gtest.h>

#include <string>

namespace craze {
namespace {

TEST(Crc32, IsThatOfTheCatalogues) {
  EXPECT_EQ(crc32(""), 0u);
  EXPECT_EQ(crc32("123456789"), 0xCBF43926u);
  EXPECT_EQ(crc32("The quick brown fox jumps over the lazy dog"), 0x414FA339u);
  EXPECT_EQ(crc32(std::string_view("IEND")), 0xAE426082u);
}

TEST(Crc32, GoesByEveryByteAtAnyLength) {
  for (std::size_t length = 1; length < 40; ++length) {
    const std::string text(length, 'a');
    for (std::size_t i = 0; i < length; ++i) {
      std::string other = text;
      other[i] ^= static_cast<char>(0x80);
      EXPECT_NE(crc32(other), crc32(text)) << length << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace craze
