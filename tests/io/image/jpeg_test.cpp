// Pictures in JPEG, made here; only where the library is there.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "craze/io/image/read_image.h"
#include "io/io_test_tools.h"

#ifdef CRAZE_JPEG
#include <cstdio>  // before jpeglib.h, which uses FILE

#include <jpeglib.h>
#endif

namespace craze {
namespace {

#ifdef CRAZE_JPEG

/// A smooth ramp: red grows to the right, green downwards; grey has red alone.
std::string ramp(int channels, bool progressive = false) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* out = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &out, &size);
  jpeg.image_width = 40;
  jpeg.image_height = 24;
  jpeg.input_components = channels;
  jpeg.in_color_space = channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 95, TRUE);
  if (progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  for (int y = 0; y < 24; ++y) {
    std::vector<unsigned char> row;
    for (int x = 0; x < 40; ++x) {
      for (int c = 0; c < channels; ++c) {
        row.push_back(static_cast<unsigned char>(c == 0 ? 6 * x : c == 1 ? 10 * y : 128));
      }
    }
    unsigned char* first = row.data();
    jpeg_write_scanlines(&jpeg, &first, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string bytes(reinterpret_cast<const char*>(out), size);
  jpeg_destroy_compress(&jpeg);
  std::free(out);
  return bytes;
}

TEST(Jpeg, ColoursAndGreyComeOutNearTheirValues) {
  for (const int channels : {1, 3}) {
    for (const bool progressive : {false, true}) {
      const Image image = read_image(ramp(channels, progressive), "a.png");  // by content
      ASSERT_EQ(image.width, 40);
      ASSERT_EQ(image.height, 24);
      ASSERT_EQ(image.channels, channels);
      EXPECT_NEAR(image.value(20, 12, 0), 120 / 255.0, 0.05);
      if (channels == 3) {
        EXPECT_NEAR(image.value(20, 12, 1), 120 / 255.0, 0.05);
      }
    }
  }
}

TEST(Jpeg, DamagedFilesAreRefusedInOneLine) {
  const std::string good = ramp(3);
  for (std::size_t n = 3; n < good.size() - 2; n += 7) {
    const std::string message = message_of([&] { read_image(good.substr(0, n), "cut"); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  for (std::size_t i = 3; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x55);
    try {
      read_image(bad, "flipped");
    } catch (const Error&) {
    }
  }
}

TEST(Jpeg, SizesThatLieReserveNoMemory) {
  std::string bytes = ramp(1);
  const std::size_t frame = bytes.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  for (const std::size_t side : {5u, 7u}) bytes[frame + side] = '\x1f';
  EXPECT_NE(message_of([&] { read_image(bytes, "a.jpg"); }).find("too short"), std::string::npos);
}

#else

TEST(Jpeg, WithoutItsLibraryIsRefusedByName) {
  const std::string message = message_of([] { read_image("\xff\xd8\xff\xe0", "a.jpg"); });
  EXPECT_EQ(message, "cannot read picture (a.jpg): this build of craze reads no JPEG");
}

#endif

}  // namespace
}  // namespace craze
