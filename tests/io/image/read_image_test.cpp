#include "craze/io/image/read_image.h"

#include <gtest/gtest.h>

#include <vector>

#include "craze/error.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

TEST(ReadImage, ReadsBilinearlyFromTheLowerLeftAndRepeats) {
  GreyImage image{2, 2, {0.0f, 1.0f, 0.5f, 0.25f}};  // top row 0 1, bottom row ½ ¼
  EXPECT_DOUBLE_EQ(image.sample({0.25, 0.75}), 0);
  EXPECT_DOUBLE_EQ(image.sample({0.75, 0.75}), 1);
  EXPECT_DOUBLE_EQ(image.sample({0.25, 0.25}), 0.5);
  EXPECT_DOUBLE_EQ(image.sample({0.5, 0.5}), 1.75 / 4);
  EXPECT_DOUBLE_EQ(image.sample({0, 0.75}), 0.5);
  EXPECT_DOUBLE_EQ(image.sample({-2.75, 7.25}), 0.5);
  EXPECT_DOUBLE_EQ(image.sample({1, 1}), image.sample({0, 0}));
}

TEST(ReadImage, WhatIsNoPictureIsRefusedAsSuch) {
  for (const char* const bytes : {"", "P5 2 2 255 ...."}) {
    EXPECT_EQ(message_of([&] { read_image(bytes, "mask"); }),
              "cannot read picture (mask): it is neither a PNG nor a JPEG file");
  }
}

TEST(ReadImage, NamesThePathOfWhatIsNotThere) {
  try {
    read_image_file("no/such/mask.png");
    FAIL();
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "cannot read picture (no/such/mask.png): No such file or directory");
  }
  EXPECT_THROW(read_image_file("."), Error);
}

}  // namespace
}  // namespace craze
