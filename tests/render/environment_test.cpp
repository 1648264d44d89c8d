#include "craze/render/light/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "craze/error.h"
#include "craze/render/light/environment_file.h"
#include "craze/render/light/radiance_picture.h"
#include "craze/render/light/studio.h"
#include "craze/render/png.h"
#include "error_message.h"
#include "temporary_folder.h"

namespace craze::render {
namespace {

/// width × width / 2 of one radiance, with a square of another that begins at (x, y).
craze::Image lit(int width, float all, int x, int y, int size, float lamp) {
  craze::Image image;
  image.width = width;
  image.height = width / 2;
  image.channels = 3;
  std::vector<float> values(static_cast<std::size_t>(3) * image.width * image.height, all);
  for (int row = y; row < y + size; ++row) {
    for (int column = x; column < x + size; ++column) {
      for (int c = 0; c < 3; ++c) {
        values[static_cast<std::size_t>(3) * (row * image.width + column) + c] = lamp;
      }
    }
  }
  image.values = std::move(values);
  return image;
}

/// The mean of a function of directions over the sphere.
template <class Function>
double mean(Function f) {
  double sum = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {  // Fibonacci's lattice
    const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z), phi = 2.399963229728653 * i;
    sum += f(Vec3f(static_cast<float>(r * std::cos(phi)), static_cast<float>(z),
                   static_cast<float>(r * std::sin(phi))));
  }
  return sum / n;
}

TEST(Environment, OneRadianceEverywhereIsSkyAlone) {
  const Environment even(lit(64, 7, 0, 0, 0, 0));
  EXPECT_EQ(luminance(even.lamp_light()), 0);
  for (const Vec3f& d : {Vec3f(0, 1, 0), Vec3f(0, -1, 0), Vec3f(0, 0, -1), Vec3f(1, 0, 0)}) {
    EXPECT_NEAR(luminance(even.sky(d)), 0.55, 1e-3);
    EXPECT_NEAR(luminance(even.radiance(d)), 0.55, 1e-3);
  }
}

TEST(Environment, WhatIsBrightestIsALampAndTheRestIsSky) {
  // Eight pixels of 512 below the top, a quarter to the right of the middle.
  const Environment sunny(lit(1024, 1, 764, 124, 8, 3000));
  const double turn = 2 * M_PI * (768.0 / 1024 - 0.5), fall = M_PI * 128.0 / 512;
  const Vec3f towards(static_cast<float>(std::sin(fall) * std::sin(turn)),
                      static_cast<float>(std::cos(fall)),
                      static_cast<float>(std::sin(fall) * std::cos(turn)));
  EXPECT_GT(sunny.lamp_direction().dot(towards), 0.9995);
  EXPECT_LT(sunny.lamp_size(), 0.06);
  // Nothing is lost: the mean of lamp and sky is that of the picture, and the studio's.
  const double sky = mean([&](const Vec3f& d) { return luminance(sunny.sky(d)); });
  EXPECT_NEAR(sky + luminance(sunny.lamp_light()) / 4, 0.55, 0.01);
  EXPECT_LT(luminance(sunny.sky(towards)), 1.1 * luminance(sunny.sky(-towards)));
  EXPECT_GT(luminance(sunny.radiance(towards)), 1000 * luminance(sunny.sky(towards)));
}

TEST(Environment, TheSeamBehindAndThePolesAreSmooth) {
  craze::Image image = lit(64, 1, 0, 0, 0, 0);
  auto& values = std::get<std::vector<float>>(image.values);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      const float wave = 1.5f + std::cos(static_cast<float>(2 * M_PI * (x + 0.5) / 64));
      for (int c = 0; c < 3; ++c) values[static_cast<std::size_t>(3) * (64 * y + x) + c] = wave;
    }
  }
  const Environment wavy(image);
  for (const float height : {-0.9f, 0.0f, 0.9f}) {
    const Vec3f left = Vec3f(-1e-4f, height, -1).normalized(),
                right = Vec3f(1e-4f, height, -1).normalized();
    EXPECT_NEAR(luminance(wavy.radiance(left)), luminance(wavy.radiance(right)), 1e-3);
    EXPECT_NEAR(luminance(wavy.sky(left)), luminance(wavy.sky(right)), 1e-3);
  }
}

TEST(Environment, ASmallPictureHasCellsToo) {
  const Environment tiny(lit(2, 1, 0, 0, 0, 0));
  EXPECT_NEAR(luminance(tiny.sky({0, 0, 1})), 0.55, 1e-3);
}

TEST(Environment, WhatIsNoPictureOfAllDirectionsIsRefused) {
  const auto error = [](craze::Image image) {
    return error_of([&] { Environment(std::move(image), "sky.hdr"); }, ErrorKind::request);
  };
  EXPECT_EQ(error(lit(64, 0, 0, 0, 0, 0)), "cannot light a picture (sky.hdr): it is black");
  craze::Image square = lit(64, 1, 0, 0, 0, 0);
  square.width = 32;
  EXPECT_NE(error(square).find("this one is 32 × 32"), std::string::npos);
  EXPECT_NE(error({}).find("twice as wide"), std::string::npos);
  for (const float wrong :
       {-1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_NE(error(lit(64, 1, 5, 5, 1, wrong)).find("negative or not finite"), std::string::npos);
  }
}

TEST(Environment, TheStudioTurnsItWithTheCamera) {
  Camera camera{};
  camera.right = {1, 0, 0};
  camera.up = camera.vertical = {0, 0, 1};
  camera.forward = {0, 1, 0};
  camera.tan_x = camera.tan_y = 0.2;
  const auto sun = std::make_shared<const Environment>(lit(256, 1, 126, 62, 4, 3000));
  const auto lamp_at = [&](double turn) {
    return Studio(camera, Rgb::Ones(), {}, {sun, turn}).lamp_direction();
  };
  EXPECT_GT(lamp_at(0).dot(Vec3f(0, 1, 0)), 0.999) << "ahead";
  EXPECT_GT(lamp_at(90).dot(Vec3f(1, 0, 0)), 0.999) << "to the right";
  const Studio turned(camera, Rgb::Ones(), {}, {sun, 90});
  EXPECT_GT(luminance(turned.reflection({1, 0, 0})), 50 * luminance(turned.reflection({0, 1, 0})));
}

/// A Radiance file of that size.
std::string radiance(int width, int height, const std::string& pixels) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
         std::to_string(width) + "\n" + pixels;
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::vector<float> reds(const std::string& bytes) {
  const craze::Image image = read_radiance_picture(bytes, "sky.hdr");
  std::vector<float> values;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      values.push_back(static_cast<float>(image.value(x, y, 0)));
    }
  }
  return values;
}

// A mantissa of 128 and an exponent of 129 are 1.
const std::string one("\x80\x80\x80\x81"), bright("\x80\x40\x20\x89");

TEST(RadiancePicture, PixelsHaveAMantissaEachAndAnExponentInCommon) {
  const craze::Image image = read_radiance_picture(radiance(2, 1, one + bright), "sky.hdr");
  EXPECT_EQ(image.value(0, 0, 0), 1);
  EXPECT_EQ(image.value(1, 0, 0), 256);
  EXPECT_EQ(image.value(1, 0, 1), 128);
  EXPECT_EQ(image.value(1, 0, 2), 64);
  EXPECT_EQ(reds(radiance(2, 1, one + std::string("\xff\xff\xff\0", 4)))[1], 0);
}

TEST(RadiancePicture, RunsAreOfPixelsOrOfChannels) {
  const std::string again("\1\1\1\3");
  EXPECT_EQ(reds(radiance(5, 1, one + again + bright)), (std::vector<float>{1, 1, 1, 1, 256}));
  // 2 + 256 times.
  const std::string twice("\1\1\1\2"), more("\1\1\1\1");
  EXPECT_EQ(reds(radiance(259, 1, one + twice + more)), std::vector<float>(259, 1));
  // Eight pixels: a run of seven and one as it is, by channel.
  std::string row("\2\2\0\x08", 4);
  for (const char* channel :
       {"\x87\x80\1\x80", "\x87\x80\1\x40", "\x87\x80\1\x20", "\x87\x81\1\x89"}) {
    row += channel;
  }
  EXPECT_EQ(reds(radiance(8, 2, row + row)),
            (std::vector<float>{1, 1, 1, 1, 1, 1, 1, 256, 1, 1, 1, 1, 1, 1, 1, 256}));
}

TEST(RadiancePicture, EveryShorterFileIsCutOff) {
  std::string row("\2\2\0\x08", 4);
  for (int c = 0; c < 4; ++c) row += "\x87\x80\1\x80";
  for (const std::string& whole : {radiance(8, 2, row + row), radiance(3, 2, repeated(one, 6))}) {
    EXPECT_NO_THROW(read_radiance_picture(whole, ""));
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_THROW(read_radiance_picture(whole.substr(0, size), ""), Error) << size;
    }
  }
}

TEST(RadiancePicture, WhatIsWrongIsSaid) {
  const auto message = [](const std::string& bytes) {
    return error_of([&] { read_radiance_picture(bytes, "sky.hdr"); }, ErrorKind::input);
  };
  const std::string before = "cannot read environment (sky.hdr): ";
  EXPECT_EQ(message(radiance(4, 2, one)), before + "it is cut off");
  EXPECT_EQ(message(radiance(40000, 20000, one)), before + "it has too many pixels");
  EXPECT_EQ(message(radiance(16000, 8000, one)),
            before + "it has too many pixels for so short a file");
  EXPECT_EQ(message(radiance(4096, 2048, one)), before + "it is cut off");
  EXPECT_EQ(message(radiance(2, 1, "\1\1\1\1")), before + "a run repeats nothing");
  EXPECT_EQ(message(radiance(2, 1, one + "\1\1\1\2")), before + "a run is longer than its row");
  EXPECT_EQ(message(radiance(8, 1, std::string("\2\2\0\x09", 4))),
            before + "a row has another length than the picture");
  EXPECT_EQ(message("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n"),
            before + "its format is 32-bit_rle_xyze, not 32-bit_rle_rgbe");
  EXPECT_EQ(message("#?RADIANCE\n\n+Y 1 +X 2\n"),
            before + "its size is not given as -Y HEIGHT +X WIDTH");
  EXPECT_EQ(message("#?RADIANCE\n\n-Y 1 +X 0\n"),
            before + "its size is not given as -Y HEIGHT +X WIDTH");
  EXPECT_NO_THROW(read_radiance_picture(
      "#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 2\r\n" + one + one, ""));
  EXPECT_EQ(message("#?RADIANCE"), before + "its header has no end");
}

TEST(EnvironmentFile, IsToldByItsContent) {
  const TemporaryFolder folder;
  const std::string path = (folder / "sky.png").string();
  const auto write = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  };
  write(radiance(4, 2, repeated(one, 8)));
  EXPECT_NEAR(luminance(read_environment(path, {})->sky({0, 0, 1})), 0.55, 1e-3);
  write_png(path, {4, 2, std::vector<std::uint8_t>(24, 200)});
  EXPECT_NEAR(luminance(read_environment(path, {})->sky({0, 0, 1})), 0.55, 1e-3);
  write("no picture");
  EXPECT_NE(error_of([&] { read_environment(path, {}); }, ErrorKind::input).find(path),
            std::string::npos);
}

}  // namespace
}  // namespace craze::render
