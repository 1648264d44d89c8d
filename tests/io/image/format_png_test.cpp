#include "craze/io/image/format_png.h"

#include <gtest/gtest.h>

#include "craze/base/random.h"
#include "craze/io/image/read_image.h"

namespace craze {
namespace {

#ifdef CRAZE_PNG

TEST(FormatPng, ReadsBackAsItWas) {
  for (const int channels : {1, 3}) {
    for (const int bits : {8, 16}) {
      PngPicture picture{7, 5, channels, bits, {}};
      Random random(1);
      for (int i = 0; i < 7 * 5 * channels; ++i) {
        picture.values.push_back(static_cast<std::uint16_t>(random.below(1u << bits)));
      }
      const Image read = read_image(format_png(picture), "a picture");
      ASSERT_EQ(read.width, 7);
      ASSERT_EQ(read.height, 5);
      ASSERT_EQ(read.channels, channels);
      for (std::size_t i = 0; i < picture.values.size(); ++i) {
        const int number = bits == 8 ? std::get<0>(read.values)[i] : std::get<1>(read.values)[i];
        EXPECT_EQ(number, picture.values[i]);
      }
    }
  }
}

#endif

}  // namespace
}  // namespace craze
