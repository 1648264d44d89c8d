// Pictures in PNG, made here; only where the library is there.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "craze/error.h"
#include "craze/io/image/read_image.h"
#include "io/io_test_tools.h"

#ifdef CRAZE_PNG
#include <png.h>
#endif

namespace craze {
namespace {

#ifdef CRAZE_PNG

struct Layout {
  int width, height, color_type, depth;
  bool interlaced = false;
};

/// A PNG whose sample c of pixel (x, y) is value(x, y, c), in big-endian order.
std::string encode(const Layout& layout, int channels,
                   const std::function<unsigned(int, int, int)>& value) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &out,
      [](png_structp p, png_bytep data, std::size_t n) {
        static_cast<std::string*>(png_get_io_ptr(p))
            ->append(reinterpret_cast<const char*>(data), n);
      },
      nullptr);
  png_set_IHDR(png, info, layout.width, layout.height, layout.depth, layout.color_type,
               layout.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (layout.color_type == PNG_COLOR_TYPE_PALETTE) {
    const png_color palette[2] = {{0, 0, 0}, {255, 255, 255}};
    png_set_PLTE(png, info, palette, 2);
  }
  png_write_info(png, info);
  std::vector<std::vector<png_byte>> rows(layout.height);
  std::vector<png_bytep> pointers;
  for (int y = 0; y < layout.height; ++y) {
    for (int x = 0; x < layout.width; ++x) {
      for (int c = 0; c < channels; ++c) {
        if (layout.depth == 16) rows[y].push_back(value(x, y, c) >> 8);
        rows[y].push_back(value(x, y, c) & 255);
      }
    }
    pointers.push_back(rows[y].data());
  }
  png_write_image(png, pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return out;
}

std::string grey_ramp(bool interlaced = false) {
  return encode({16, 9, PNG_COLOR_TYPE_GRAY, 8, interlaced}, 1,
                [](int x, int y, int) { return static_cast<unsigned>(x * 10 + y); });
}

void expect_refused(const std::string& bytes, const std::string& why) {
  try {
    read_image(bytes, "mask.png");
    FAIL() << why;
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_EQ(std::string(e.what()).rfind("cannot read picture (mask.png): ", 0), 0u) << e.what();
    EXPECT_NE(std::string(e.what()).find(why), std::string::npos) << e.what();
  }
}

TEST(Png, EveryKindOfPngGivesTheSameGrey) {
  const auto read = [](const std::string& bytes) { return to_grey(read_image(bytes, "a")); };
  const GreyImage ramp = read(grey_ramp());
  ASSERT_EQ(ramp.width, 16);
  ASSERT_EQ(ramp.height, 9);
  EXPECT_FLOAT_EQ(ramp.pixels[3 * 16 + 7], 73 / 255.0f);
  EXPECT_EQ(read(grey_ramp(true)).pixels, ramp.pixels);
  const auto wide = encode({16, 9, PNG_COLOR_TYPE_GRAY, 16}, 1, [](int x, int y, int) {
    return static_cast<unsigned>(257 * (x * 10 + y));
  });
  const auto color = encode({16, 9, PNG_COLOR_TYPE_RGB_ALPHA, 8}, 4, [](int x, int y, int c) {
    return static_cast<unsigned>(c == 3 ? 9 : x * 10 + y);
  });
  for (std::size_t i = 0; i < ramp.pixels.size(); ++i) {
    EXPECT_FLOAT_EQ(read(wide).pixels[i], ramp.pixels[i]);
    EXPECT_FLOAT_EQ(read(color).pixels[i], ramp.pixels[i]);
  }
  const auto palette = encode({4, 1, PNG_COLOR_TYPE_PALETTE, 8}, 1,
                              [](int x, int, int) { return static_cast<unsigned>(x % 2); });
  EXPECT_EQ(read(palette).pixels, (std::vector<float>{0, 1, 0, 1}));
}

TEST(Png, DamagedFilesAreRefusedWithAReason) {
  const std::string good = grey_ramp();
  for (std::size_t n = 8; n + 13 < good.size(); ++n) {
    EXPECT_THROW(read_image(std::string_view(good).substr(0, n), "cut"), Error) << n;
  }
  for (std::size_t i = 0; i + 12 < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x55);
    try {
      read_image(bad, "flipped");
    } catch (const Error&) {
    }
  }
}

/// The ramp with another size in its header, checksum corrected.
std::string with_size(std::uint32_t width, std::uint32_t height) {
  std::string bytes = grey_ramp();
  for (int k = 0; k < 4; ++k) {
    bytes[16 + k] = static_cast<char>(width >> (24 - 8 * k));
    bytes[20 + k] = static_cast<char>(height >> (24 - 8 * k));
  }
  std::uint32_t crc = 0xffffffffu;
  for (int i = 12; i < 29; ++i) {
    crc ^= static_cast<unsigned char>(bytes[i]);
    for (int k = 0; k < 8; ++k) crc = crc & 1 ? (crc >> 1) ^ 0xedb88320u : crc >> 1;
  }
  crc = ~crc;
  for (int k = 0; k < 4; ++k) bytes[29 + k] = static_cast<char>(crc >> (24 - 8 * k));
  return bytes;
}

TEST(Png, SizesThatLieReserveNoMemory) {
  expect_refused(with_size(2000000000, 2000000000), "16,384 pixels wide or high");
  expect_refused(with_size(16384, 16384), "too large");
  expect_refused(with_size(8192, 8192), "too short");
  expect_refused(with_size(0, 5), "Invalid IHDR");
}

#else

TEST(Png, WithoutItsLibraryIsRefusedByName) {
  const std::string message = message_of([] { read_image("\x89PNG\r\n\x1a\n", "a.png"); });
  EXPECT_EQ(message, "cannot read picture (a.png): this build of craze reads no PNG");
}

#endif

}  // namespace
}  // namespace craze
