#include "craze/io/image/encode_png.h"

#include <gtest/gtest.h>

#include "craze/io/image/deflate.h"
#include "craze/io/image/read_image.h"

namespace craze {
namespace {

#ifdef CRAZE_PNG

TEST(EncodePng, IsReadBackNumberByNumber) {
  if (!has_deflate()) GTEST_SKIP() << "no zlib";
  std::uint32_t state = 7;
  for (int channels = 1; channels <= 4; ++channels) {
    std::vector<std::uint8_t> numbers(static_cast<std::size_t>(37 * 23 * channels));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      state = 1664525 * state + 1013904223;
      // Smooth above, rough below, so that every filter is the best one somewhere.
      numbers[i] = static_cast<std::uint8_t>(i < numbers.size() / 2 ? i / 37 : state >> 24);
    }
    const Image image{37, 23, channels, numbers};
    const Image back = read_image(encode_png(image), "a.png");
    EXPECT_EQ(back.width, 37);
    EXPECT_EQ(back.height, 23);
    ASSERT_EQ(back.channels, channels);
    EXPECT_EQ(std::get<std::vector<std::uint8_t>>(back.values), numbers);
  }
}

#endif

}  // namespace
}  // namespace craze
