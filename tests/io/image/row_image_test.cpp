#include "craze/io/image/row_image.h"

#include <gtest/gtest.h>

#include <fstream>

#include "craze/error.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/image/read_image.h"
#include "temporary_folder.h"

namespace craze {
namespace {

TEST(RowImages, SayWhereTheyCannotBeWritten) {
  const Context context;
  EXPECT_THROW(new_png16("/nonexistent/map.png", {1, 1, 1}, context), Error);
  EXPECT_THROW(new_exr("/nonexistent/map.exr", {1, 1, 1}, context), Error);
}

#ifdef CRAZE_PNG  // zlib comes with libpng

std::vector<float> ramp(int width, int height, int channels) {
  std::vector<float> values;
  for (int i = 0; i < width * height * channels; ++i) {
    values.push_back(static_cast<float>(i * 7919 % 1000) / 999.0f);
  }
  return values;
}

void write(RowImage& image, const std::vector<float>& values, int height) {
  const std::size_t row = values.size() / static_cast<std::size_t>(height);
  for (int first = 0; first < height; first += image.block_rows()) {
    const int count = std::min(image.block_rows(), height - first);
    image.write(first, image.pack(first, count, values.data() + row * first));
  }
}

TEST(RowImages, ComeBackFromPngToTheLastStep) {
  const TemporaryFolder folder;
  const Context context;
  for (const int channels : {1, 3}) {
    for (const int height : {1, 32, 77}) {
      const int width = 45;
      const std::vector<float> values = ramp(width, height, channels);
      const auto image = new_png16(folder.path() / "map.png", {width, height, channels}, context);
      write(*image, values, height);
      image->finish();
      const Image read = read_image_file(folder.path() / "map.png");
      ASSERT_EQ(read.width, width);
      ASSERT_EQ(read.height, height);
      ASSERT_EQ(read.channels, channels);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto pixel = static_cast<int>(i) / channels;
        ASSERT_NEAR(read.value(pixel % width, pixel / width, static_cast<int>(i) % channels),
                    values[i], 0.5001 / 65535);
      }
    }
  }
}

TEST(RowImages, ScaleIntegersFromTheirRangeAndCutOffTheRest) {
  const TemporaryFolder folder;
  const Context context;
  RowImageFormat format{3, 1, 1};
  format.low[0] = -2;
  format.high[0] = 6;
  const auto image = new_png16(folder.path() / "map.png", format, context);
  write(*image, {-3, 2, 7}, 1);
  image->finish();
  const Image read = read_image_file(folder.path() / "map.png");
  EXPECT_EQ(read.value(0, 0, 0), 0);
  EXPECT_NEAR(read.value(1, 0, 0), 0.5, 1e-5);
  EXPECT_EQ(read.value(2, 0, 0), 1);
}

TEST(RowImages, AreNotThereBeforeTheyAreWhole) {
  const TemporaryFolder folder;
  const Context context;
  for (const bool png : {true, false}) {
    const auto path = folder.path() / "map";
    {
      const RowImageFormat format{4, 40, 1};
      const auto image = png ? new_png16(path, format, context) : new_exr(path, format, context);
      const std::vector<float> values = ramp(4, 40, 1);
      image->write(0, image->pack(0, image->block_rows(), values.data()));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
}

// Each block's place in the table is where the block is: its first row stands there.
TEST(RowImages, OfExrHaveATableOfTheirBlocks) {
  const TemporaryFolder folder;
  const Context context;
  const int width = 33, height = 50;
  const auto image = new_exr(folder.path() / "map.exr", {width, height, 3}, context);
  write(*image, ramp(width, height, 3), height);
  image->finish();
  std::ifstream file(folder.path() / "map.exr", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(load<std::uint32_t>(bytes.data()), 20000630u);
  const std::string last = "screenWindowWidth";
  const std::size_t table = bytes.find(last) + last.size() + 1 + 6 + 4 + 4 + 1;
  for (int block = 0; block < 4; ++block) {
    const auto offset = load<std::uint64_t>(bytes.data() + table + 8 * block);
    ASSERT_LT(offset, bytes.size());
    EXPECT_EQ(load<std::uint32_t>(bytes.data() + offset), 16u * block);
  }
}

#else

TEST(RowImages, WithoutZlibAreRefusedByName) {
  const Context context;
  const TemporaryFolder folder;
  for (const auto make : {&new_png16, &new_exr}) {
    try {
      const auto image = make(folder / "map", {1, 1, 1}, context);
      const float value = 0;
      image->write(0, image->pack(0, 1, &value));
      FAIL() << "it was packed";
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("zlib"), std::string::npos);
    }
  }
}

#endif

}  // namespace
}  // namespace craze
