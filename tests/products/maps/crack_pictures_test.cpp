#include "craze/products/maps/pictures/crack_pictures.h"

#include <gtest/gtest.h>

#include "craze/base/srgb.h"
#include "plates.h"

namespace craze {
namespace {

constexpr int size = 64;

const std::vector<std::uint8_t>& bytes_of(const SurfacePicture& picture) {
  return std::get<std::vector<std::uint8_t>>(picture.image.values);
}

/// A picture of that many channels with a gradient in each.
SurfacePicture gradient(int channels) {
  std::vector<std::uint8_t> numbers;
  for (int i = 0; i < size * size * channels; ++i) {
    numbers.push_back(static_cast<std::uint8_t>(60 + i / channels % size + 9 * (i % channels)));
  }
  return {{size, size, channels, numbers}};
}

SurfacePictures cracked(const MapSurface& surface, const SurfacePictures& own,
                        const CrackStain& stain = {}, const Color& factor = {1, 1, 1, 1}) {
  const Context context;
  CrackPictures pictures(own, factor, stain, context);
  bake_surface(surface, options_of(size, CrackPictures::maps()), pictures, context);
  return pictures.take();
}

std::vector<float> map_of(const MapSurface& surface, MapKind kind) {
  return bake(surface, options_of(size, {kind})).front().values;
}

TEST(CrackPictures, AreTheMaterialsOwnWhereThereIsNoCrack) {
  const MapSurface surface = plate_with(5, known_cracks());
  SurfacePictures own;
  own.base_color = gradient(4);
  own.roughness = gradient(3);
  own.occlusion = gradient(1);
  const SurfacePictures made = cracked(surface, own);
  const std::vector<float> mask = map_of(surface, MapKind::mask);
  ASSERT_EQ(made.base_color.image.channels, 4);
  int whole = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] > 0) continue;
    ++whole;
    for (std::size_t c = 0; c < 4; ++c) {
      ASSERT_EQ(bytes_of(made.base_color)[4 * i + c], bytes_of(own.base_color)[4 * i + c]);
    }
    ASSERT_EQ(bytes_of(made.roughness)[3 * i], bytes_of(own.occlusion)[i]);
    ASSERT_EQ(bytes_of(made.roughness)[3 * i + 1], bytes_of(own.roughness)[3 * i + 1]);
    ASSERT_EQ(bytes_of(made.roughness)[3 * i + 2], bytes_of(own.roughness)[3 * i + 2]);
  }
  EXPECT_GT(whole, size * size / 2);
}

TEST(CrackPictures, AreStainedPalerInTheCracksThatCameLast) {
  std::vector<MapCrack> cracks{crack_from(0, 0.3, 1, 0.3, 0.2, 0.2),
                               crack_from(0, 0.7, 1, 0.7, 0.2, 0.2)};
  cracks[0].time = 1;
  cracks[1].time = 3;
  const MapSurface surface = plate_with(5, std::move(cracks));
  CrackStain black{Color{0, 0, 0, 1}};
  const auto left = [&](double v) {  // of the white surface, in the middle of a crack
    const int row = static_cast<int>((1 - v) * size);
    const SurfacePictures made = cracked(surface, {}, black);
    const auto at = 3 * static_cast<std::size_t>(row * size + size / 2);
    return srgb_to_linear(static_cast<float>(bytes_of(made.base_color)[at]) / 255.0f);
  };
  EXPECT_NEAR(left(0.3), 0, 0.005);
  EXPECT_NEAR(left(0.7), 0, 0.005);
  black.late = 0.4;
  EXPECT_NEAR(left(0.3), 0, 0.005);
  EXPECT_NEAR(left(0.7), 0.6, 0.005);
}

TEST(CrackPictures, HaveTheStainByTheShareOfTheTexelThatIsOpen) {
  const MapSurface surface = plate_with(5, known_cracks());
  const std::vector<float> mask = map_of(surface, MapKind::mask);
  const CrackStain brown{Color{0.2f, 0.1f, 0.05f, 1}};
  const Color factor{0.5f, 0.5f, 0.5f, 1};
  const SurfacePictures made = cracked(surface, {}, brown, factor);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      // As it is shown: times the factor.
      const double shown =
          factor[c] *
          srgb_to_linear(static_cast<float>(bytes_of(made.base_color)[3 * i + c]) / 255.0f);
      const double wanted = factor[c] + mask[i] * ((*brown.color)[c] - factor[c]);
      ASSERT_NEAR(shown, wanted, 0.005) << i;
    }
    ASSERT_NEAR(bytes_of(made.roughness)[3 * i + 2] / 255.0, 1 - mask[i], 0.003);
  }
}

TEST(CrackPictures, AddUpTheSlopesOfBothNormals) {
  const MapSurface surface = plate_with(5, known_cracks());
  const std::vector<float> groove = map_of(surface, MapKind::normal);
  // A slope of 0.4 along u, drawn half as strong.
  const Vec3 leaning = Vec3(-0.4, 0, 1).normalized();
  std::vector<std::uint8_t> numbers;
  for (int i = 0; i < 3 * size * size; ++i) {
    numbers.push_back(static_cast<std::uint8_t>(std::lround((0.5 + 0.5 * leaning[i % 3]) * 255)));
  }
  SurfacePictures own;
  own.normal.image = {size, size, 3, numbers};
  own.normal_scale = 0.5;
  const SurfacePictures made = cracked(surface, own);
  for (std::size_t i = 0; i < groove.size() / 3; ++i) {
    const auto tilt = [](const auto& n, double full, std::size_t at) {
      const double x = 2 * n[at] / full - 1, y = 2 * n[at + 1] / full - 1,
                   z = 2 * n[at + 2] / full - 1;
      return Vec2(x / z, y / z);
    };
    const Vec2 wanted = tilt(groove, 1, 3 * i) + Vec2(-0.2, 0);
    if (wanted.norm() > 2) continue;  // 8 bits say little of steep ones
    ASSERT_LT((tilt(bytes_of(made.normal), 255, 3 * i) - wanted).norm(), 0.05) << i;
  }
}

TEST(CrackPictures, TakeAPictureOfAnotherSizeAndPlace) {
  const MapSurface surface = plate_with(5, {});
  SurfacePictures own;
  own.base_color.image = {2, 1, 3, std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255}};
  own.base_color.place << 2, 0, 0, 0, 1, 0;  // twice along u
  const SurfacePictures made = cracked(surface, own);
  // The white pixel's middle is at u = 3/8 and 7/8, the black one's at 1/8 and 5/8.
  const auto at = [&](int x) { return bytes_of(made.base_color)[3 * (10 * size + x)]; };
  EXPECT_LT(at(size / 8), 10);
  EXPECT_GT(at(3 * size / 8), 245);
  EXPECT_LT(at(5 * size / 8), 10);
  EXPECT_GT(at(7 * size / 8), 245);
}

}  // namespace
}  // namespace craze
