#include "craze/render/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <filesystem>

#include "craze/error.h"

namespace craze::render {
namespace {

namespace fs = std::filesystem;

Image gradient() {
  Image image{5, 3, {}};
  for (int i = 0; i < 45; ++i) image.rgb.push_back(static_cast<std::uint8_t>(5 * i));
  return image;
}

TEST(Png, HoldsThePixelsItWasGiven) {
  const std::string path = testing::TempDir() + "craze_gradient.png";
  const Image image = gradient();
  write_png(path, image);
  png_image read{};
  read.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_file(&read, path.c_str()));
  EXPECT_EQ(read.width, 5u);
  EXPECT_EQ(read.height, 3u);
  read.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(read));
  ASSERT_TRUE(png_image_finish_read(&read, nullptr, rgb.data(), 0, nullptr));
  EXPECT_EQ(rgb, image.rgb);
  fs::remove(path);
}

TEST(Png, LeavesNothingBehindWhenItFails) {
  // A directory of that name with something in it cannot be replaced by a file.
  const fs::path folder = fs::path(testing::TempDir()) / "craze_png_folder";
  fs::create_directories(folder / "occupied.png" / "inside");
  EXPECT_THROW(write_png((folder / "occupied.png").string(), gradient()), Error);
  EXPECT_THROW(write_png((folder / "missing" / "a.png").string(), gradient()), Error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}), 1);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace craze::render
