#include "craze/render/look.h"

#include <gtest/gtest.h>

#include "craze/error.h"
#include "craze/render/picture.h"

namespace craze::render {
namespace {

/// Two by two pixels: red and green above, blue and white below.
craze::Image four_colors() {
  craze::Image image;
  image.width = image.height = 2;
  image.channels = 3;
  image.values = std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  return image;
}

void expect_color(const Rgb& is, const Rgb& wanted) {
  EXPECT_LT((is - wanted).abs().maxCoeff(), 1e-6) << is.transpose();
}

TEST(Look, AtPixelCentresATextureIsThePixel) {
  const ColorTexture texture(four_colors());
  expect_color(texture.sample({0.25f, 0.75f}), {1, 0, 0});
  expect_color(texture.sample({0.75f, 0.75f}), {0, 1, 0});
  expect_color(texture.sample({0.25f, 0.25f}), {0, 0, 1});
  expect_color(texture.sample({-0.25f, 3.25f}), {1, 1, 1});
  expect_color(texture.sample({0.5f, 0.75f}), {0.5f, 0.5f, 0});
}

TEST(Look, GreyPicturesAreGrey) {
  craze::Image image;
  image.width = image.height = 1;
  image.channels = 2;
  image.values = std::vector<std::uint16_t>{65535, 0};
  expect_color(ColorTexture(image).sample({0.5f, 0.5f}), {1, 1, 1});
}

TEST(Look, TheFactorMultipliesTheTextureWhereItIsPlaced) {
  Look look;
  look.color = {0.5f, 0.25f, 1};
  expect_color(look.at({0, 0}), look.color);
  look.texture = std::make_shared<const ColorTexture>(four_colors());
  look.place << 1, 0, 0.5f, 0, 1, 0;
  expect_color(look.at({0.25f, 0.25f}), look.color);  // white
  expect_color(look.at({0.25f, 0.75f}), {0, 0.25f, 0});
}

/// Two squares side by side, seen from straight above.
struct TwoSquares {
  SurfaceMesh mesh;
  PictureOptions options;

  TwoSquares() {
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    mesh.face_materials = {0, 0, 1, 1};
    mesh.material_names = {"left", "crack_wall"};
    for (const Triangle& t : mesh.triangles) {
      for (const std::int32_t v : t) mesh.corner_uvs.push_back(mesh.positions[v].head<2>());
    }
    options.view.elevation = 90;
    options.width = 80;
    options.height = 40;
    options.ground = false;
    options.material = find_material("plaster");
    options.material.mottle = options.material.bump = 0;
  }
  std::array<int, 3> pixel(int x, int y) const {
    const Image image = render_picture(mesh, nullptr, options, {});
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * image.width + x);
    return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
  }
};

TEST(Look, PicturesShowIt) {
  TwoSquares squares;
  Look look;
  look.texture = std::make_shared<const ColorTexture>(four_colors());
  squares.options.looks = {look};
  const auto red = squares.pixel(15, 13), blue = squares.pixel(15, 27);
  EXPECT_GT(red[0], red[2] + 80);
  EXPECT_GT(blue[2], blue[0] + 80);
}

TEST(Look, WallsAndMaterialsBeyondKeepThePicturesOwn) {
  TwoSquares squares;
  const auto plain = squares.pixel(60, 20);
  squares.options.looks = {Look{{1, 0, 0}, nullptr, {}}};
  const auto wall = squares.pixel(60, 20);
  EXPECT_NEAR(wall[1], plain[1], 8) << "but for light that the other square throws";
  squares.mesh.face_materials = {-1, -1, -1, -1};
  const auto none = squares.pixel(20, 20);
  EXPECT_NEAR(none[0], none[1], 25);
}

}  // namespace
}  // namespace craze::render
