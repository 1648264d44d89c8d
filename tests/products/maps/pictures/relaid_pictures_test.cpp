// A material's pictures in other UVs than its own.
#include "craze/products/maps/pictures/relaid_pictures.h"

#include <gtest/gtest.h>

#include "craze/products/maps/map_faces.h"
#include "craze/products/maps/pictures/sample_picture.h"
#include "products/maps/plates.h"

namespace craze {
namespace {

constexpr int size = 64;

Image picture_of(int side, auto&& pixel) {
  Image image{side, side, 3, {}};
  std::vector<std::uint8_t> values;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      for (int c = 0; c < 3; ++c) values.push_back(static_cast<std::uint8_t>(pixel(x, y, c)));
    }
  }
  image.values = std::move(values);
  return image;
}

/// The UVs of the plate turned by a right angle, mirrored, and `times` as large.
std::vector<Vec2> turned(const MapSurface& surface, double times) {
  std::vector<Vec2> uvs;
  for (const Vec2& uv : surface.surface.corner_uvs) uvs.push_back(times * Vec2(uv.y(), uv.x()));
  return uvs;
}

MapSheet sheet_of(const MapSurface& surface) {
  return uv_layout(surface, true, {}).sheets.at(0);
}

TEST(RelaidPictures, ShowAtEachTexelWhatTheSurfaceShowedThere) {
  const MapSurface surface = plate_with(3, {});
  SurfacePictures own;
  own.base_color.image = picture_of(size, [](int x, int y, int c) {
    return c == 0 ? 2 * x : c == 1 ? 2 * y : 90;
  });
  const std::vector<Vec2> uvs = turned(surface, 1);
  const RelaidPictures made =
      relaid_pictures(own, {&uvs, nullptr, nullptr, nullptr}, surface, sheet_of(surface), size, {});
  const PictureSampler before(own.base_color), after(made.pictures.base_color);
  EXPECT_NEAR(made.pixels_per_texel, 1, 1e-9);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Vec2 uv((x + 0.5) / size, (y + 0.5) / size);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(after.color(uv)[c], before.color({uv.y(), uv.x()})[c], 1e-4);
      }
    }
  }
}

// The brightness of a picture too fine for the texels is that of its light, not of its numbers.
TEST(RelaidPictures, AverageTheLightOfPixelsThatShareATexel) {
  const MapSurface surface = plate_with(3, {});
  SurfacePictures own;
  own.base_color.image =
      picture_of(size, [](int x, int y, int) { return (x + y) % 2 == 0 ? 255 : 0; });
  const std::vector<Vec2> uvs = turned(surface, 8);
  const RelaidPictures made =
      relaid_pictures(own, {&uvs, nullptr, nullptr, nullptr}, surface, sheet_of(surface), size, {});
  EXPECT_NEAR(made.pixels_per_texel, 8, 1e-9);
  constexpr double half_light = 0.7354;  // of sRGB
  for (int i = 0; i < size; ++i) {
    EXPECT_NEAR(made.pictures.base_color.image.value(i, (7 * i) % size, 1), half_light, 2e-3);
  }
}

TEST(RelaidPictures, TurnNormalsSoThatTheyLeanAsTheyDid) {
  const MapSurface surface = plate_with(3, {});
  SurfacePictures own;
  own.normal.image = picture_of(8, [](int, int, int c) {
    return c == 0 ? 200 : c == 1 ? 110 : 225;
  });
  own.normal_scale = 0.5;
  const std::vector<Vec2> uvs = turned(surface, 3);
  const RelaidPictures made =
      relaid_pictures(own, {nullptr, &uvs, nullptr, nullptr}, surface, sheet_of(surface), size, {});
  EXPECT_EQ(made.pictures.normal_scale, 1);
  SurfaceMesh old = surface.surface;
  old.corner_uvs = uvs;
  const MapFaces before(old), after(surface.surface);
  const Vec3 weights(0.2, 0.3, 0.5);
  const auto world = [&](const MapFaces& faces, const Image& image, double scale) -> Vec3 {
    const MapFrame frame = faces.frame(4, weights);
    return (scale * (2 * image.value(5, 5, 0) - 1) * frame.tangent +
            scale * (2 * image.value(5, 5, 1) - 1) * frame.bitangent +
            (2 * image.value(5, 5, 2) - 1) * frame.normal)
        .normalized();
  };
  EXPECT_LT(
      (world(before, own.normal.image, 0.5) - world(after, made.pictures.normal.image, 1)).norm(),
      1e-4);
}

TEST(RelaidPictures, GoOnBeyondTheirBordersAsTheirTextureSays) {
  const MapSurface surface = plate_with(3, {});
  const Image ramp = picture_of(size, [](int x, int, int) { return 4 * x; });
  const auto at = [&](TextureWrap wrap, double u) {
    SurfacePicture picture{ramp};
    picture.wraps = {wrap, wrap};
    return PictureSampler(picture).color({u, 0.5})[0];
  };
  EXPECT_NEAR(at(TextureWrap::repeat, 1.25), at(TextureWrap::repeat, 0.25), 1e-9);
  EXPECT_NEAR(at(TextureWrap::mirror, 1.25), at(TextureWrap::repeat, 0.75), 1e-9);
  EXPECT_NEAR(at(TextureWrap::mirror, -0.25), at(TextureWrap::repeat, 0.25), 1e-9);
  EXPECT_NEAR(at(TextureWrap::clamp, 7.3), 252 / 255.0, 1e-6);
  EXPECT_EQ(at(TextureWrap::clamp, -1e9), 0);
  EXPECT_NEAR(at(TextureWrap::clamp, 1), 252 / 255.0, 1e-6);
}

TEST(RelaidPictures, AreTheSameOnAnyNumberOfThreads) {
  const MapSurface surface = plate_with(3, {});
  SurfacePictures own;
  own.roughness.image = picture_of(31, [](int x, int y, int c) { return (x * y + c) % 256; });
  const std::vector<Vec2> uvs = turned(surface, 5.3);
  const auto made = [&](int threads) {
    Context context;
    context.threads = threads;
    return relaid_pictures(own, {nullptr, nullptr, nullptr, &uvs}, surface, sheet_of(surface), size,
                           context)
        .pictures.roughness.image.values;
  };
  EXPECT_EQ(made(1), made(3));
}

}  // namespace
}  // namespace craze
