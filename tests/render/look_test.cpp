#include "craze/render/material/look.h"
#include "craze/render/material/surface.h"

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

void expect_color(const Rgba& is, const Rgb& wanted) {
  EXPECT_LT((is.head<3>() - wanted).abs().maxCoeff(), 1e-6) << is.transpose();
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
  EXPECT_EQ(ColorTexture(image).sample({0.5f, 0.5f})[3], 0) << "and may be see-through";
}

TEST(Look, TheFactorMultipliesTheTextureWhereItIsPlaced) {
  Look look;
  look.color = {0.5f, 0.25f, 1};
  expect_color(look.at({0, 0}).color, look.color);
  look.picture.texture = std::make_shared<const ColorTexture>(four_colors());
  look.picture.place << 1, 0, 0.5f, 0, 1, 0;
  expect_color(look.at({0.25f, 0.25f}).color, look.color);  // white
  expect_color(look.at({0.25f, 0.75f}).color, {0, 0.25f, 0});
}

TEST(Look, PicturesGoOnBeyondTheirBordersAsTheirWrapsSay) {
  PlacedTexture placed;
  placed.texture = std::make_shared<const ColorTexture>(four_colors());
  const auto red_at = [&](TextureWrap wrap, float u, float v) -> Rgb {
    placed.wraps = {wrap, wrap};
    return placed.at({u, v}).head<3>();
  };
  const auto inside = [&](float u, float v) { return red_at(TextureWrap::repeat, u, v); };
  expect_color(red_at(TextureWrap::repeat, 1.25f, 0.25f), inside(0.25f, 0.25f));
  expect_color(red_at(TextureWrap::mirror, 1.25f, 0.25f), inside(0.75f, 0.25f));
  expect_color(red_at(TextureWrap::mirror, 0.25f, -0.75f), inside(0.25f, 0.75f));
  expect_color(red_at(TextureWrap::clamp, 7, 0.25f), inside(0.75f, 0.25f));
  expect_color(red_at(TextureWrap::clamp, 0.25f, -7), inside(0.25f, 0.25f));
}

TEST(Look, AlphaCoversAsItsModeSays) {
  craze::Image image;
  image.width = image.height = 1;
  image.channels = 4;
  image.values = std::vector<std::uint8_t>{255, 255, 255, 51};  // a fifth
  Look look;
  look.opacity = 0.5f;
  look.picture.texture = std::make_shared<const ColorTexture>(image);
  EXPECT_EQ(look.at({0, 0}).cover, 1);
  EXPECT_FALSE(look.is_see_through());
  look.alpha = Look::Alpha::blended;
  EXPECT_FLOAT_EQ(look.at({0, 0}).cover, 0.1f);
  EXPECT_TRUE(look.is_see_through());
  look.alpha = Look::Alpha::cut;
  EXPECT_EQ(look.at({0, 0}).cover, 0);
  look.cutoff = 0.1f - 1e-6f;
  EXPECT_EQ(look.at({0, 0}).cover, 1);
  look.picture.texture = nullptr;
  look.cutoff = 0.5f;
  EXPECT_FALSE(look.is_see_through()) << "as much as the cutoff is enough";
}

PlacedTexture one_pixel(std::vector<std::uint8_t> rgb) {
  craze::Image image;
  image.width = image.height = 1;
  image.channels = 3;
  image.values = std::move(rgb);
  return {std::make_shared<const ColorTexture>(image, Encoding::linear)};
}

TEST(Look, APictureOfWhatIsTransmittedCountsByItsRed) {
  Look look;
  look.transmission = 0.5f;
  look.transmission_picture = one_pixel({51, 255, 255});
  EXPECT_FLOAT_EQ(look.at({0, 0}).transmission, 0.1f);
  EXPECT_EQ(look.at_factor().transmission, 0.5f);
}

TEST(Look, NormalPicturesLeanBySlopesTimesTheirStrength) {
  Look look;
  EXPECT_EQ(look.tangent_normal({0, 0}), Vec3f::UnitZ());
  look.normals = one_pixel({255, 128, 255});
  EXPECT_NEAR(look.tangent_normal({0, 0}).x(), std::sqrt(0.5), 1e-5);
  look.normal_strength = 0;
  EXPECT_NEAR(look.tangent_normal({0, 0}).z(), 1, 1e-6);
  look.normals = one_pixel({255, 128, 0});  // from below
  EXPECT_EQ(look.tangent_normal({0, 0}), Vec3f::UnitZ());
}

/// The normal of a triangle in the x-y plane whose corners have these UVs, seen from above or
/// below, with a picture that leans along u and a little along v.
Vec3f leaning(const std::vector<Eigen::Vector2f>& uvs, bool from_below) {
  TracedModel model;
  model.positions = model.places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  model.triangles = {{0, 1, 2}};
  model.normals.assign(3, Vec3f::UnitZ());
  model.is_wall = {0};
  model.looks.emplace_back();
  model.looks[0].normals = one_pixel({204, 153, 230});  // 0.6, 0.2, 0.8
  model.uvs = uvs;
  const float side = from_below ? -1.0f : 1.0f;
  Material material = find_material("plaster");
  return surface_at(model, material, Ray{{0.2f, 0.2f, side}, {0, 0, -side}}, Hit{0, 1, 0.2f, 0.2f},
                    0.01f)
      .normal;
}

TEST(Look, NormalPicturesLeanAlongTheirUvs) {
  const Vec3f expected = Vec3f(0.6f, 0.2f, 0.804f).normalized();
  const auto expect_normal = [&](const Vec3f& seen, float x, float y, float z) {
    EXPECT_LT((seen - Vec3f(x, y, z)).norm(), 2e-3) << seen.transpose();
  };
  const float u = expected.x(), v = expected.y(), n = expected.z();
  expect_normal(leaning({{0, 0}, {1, 0}, {0, 1}}, false), u, v, n);
  expect_normal(leaning({{0, 0}, {1, 0}, {0, 1}}, true), -u, -v, -n);
  expect_normal(leaning({{0, 0}, {0, 1}, {-1, 0}}, false), v, -u, n);  // turned
  expect_normal(leaning({{0, 0}, {-1, 0}, {0, 1}}, false), -u, v, n);  // mirrored
  expect_normal(leaning({{0, 0}, {0, 0}, {0, 0}}, false), 0, 0, 1);    // nowhere
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
  look.picture.texture = std::make_shared<const ColorTexture>(four_colors());
  squares.options.looks = {look};
  const auto red = squares.pixel(15, 13), blue = squares.pixel(15, 27);
  EXPECT_GT(red[0], red[2] + 80);
  EXPECT_GT(blue[2], blue[0] + 80);
}

TEST(Look, WallsAndMaterialsBeyondKeepThePicturesOwn) {
  TwoSquares squares;
  const auto plain = squares.pixel(60, 20);
  squares.options.looks = {Look{{1, 0, 0}}};
  const auto wall = squares.pixel(60, 20);
  EXPECT_NEAR(wall[1], plain[1], 8) << "but for light that the other square throws";
  squares.mesh.face_materials = {-1, -1, -1, -1};
  const auto none = squares.pixel(20, 20);
  EXPECT_NEAR(none[0], none[1], 25);
}

/// A pane over a red floor, seen from straight above.
struct PaneOverFloor {
  SurfaceMesh mesh;
  PictureOptions options;

  explicit PaneOverFloor(const Look& pane, int panes = 1) {
    const auto add_square = [&](double low, double high, double z, std::int32_t material) {
      const auto first = static_cast<std::int32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(),
                            {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}});
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
      mesh.face_materials.insert(mesh.face_materials.end(), 2, material);
    };
    add_square(0, 1, 0, 0);
    for (int i = 1; i <= panes; ++i) add_square(0.2, 0.8, 0.05 * i, 1);
    mesh.material_names = {"floor", "pane"};
    options.looks = {Look{{0.7f, 0.05f, 0.05f}}, pane};
    options.view.elevation = 90;
    options.view.up = UpAxis::z;
    options.width = options.height = 60;
    options.samples = 64;
    options.ground = false;
    options.material = find_material("plaster");
    options.material.mottle = options.material.bump = 0;
    options.subject.points = mesh.positions;
  }
  std::array<int, 3> middle() const {
    const Image image = render_picture(mesh, nullptr, options, {});
    const std::size_t i = 3 * (30 * 60 + 30);
    return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
  }
  /// Without panes.
  std::array<int, 3> bare() {
    mesh.triangles.resize(2);
    mesh.face_materials.resize(2);
    return middle();
  }
};

Look blue_pane(Look::Alpha alpha, float opacity) {
  Look look;
  look.color = {0.05f, 0.05f, 0.7f};
  look.alpha = alpha;
  look.opacity = opacity;
  return look;
}

TEST(SeeThrough, WhatIsCutOutIsNotThere) {
  for (const int panes : {1, 5}) {
    PaneOverFloor cut(blue_pane(Look::Alpha::cut, 0.4f), panes);
    const auto seen = cut.middle();
    EXPECT_EQ(seen, cut.bare()) << panes;
  }
}

TEST(SeeThrough, ABlendedPaneShowsAsMuchOfTheFloorAsItDoesNotCover) {
  const auto pane = PaneOverFloor(blue_pane(Look::Alpha::blended, 1)).middle();
  PaneOverFloor floor(blue_pane(Look::Alpha::blended, 1));
  const auto bare = floor.bare();
  ASSERT_GT(bare[0], pane[0] + 80);
  int last = bare[0];
  for (const float opacity : {0.1f, 0.5f, 0.9f}) {
    const auto seen = PaneOverFloor(blue_pane(Look::Alpha::blended, opacity)).middle();
    EXPECT_LT(seen[0], last) << opacity;
    EXPECT_GT(seen[0], pane[0]) << opacity;
    last = seen[0];
  }
  const auto two = PaneOverFloor(blue_pane(Look::Alpha::blended, 0.5f), 2).middle();
  EXPECT_LT(two[0], PaneOverFloor(blue_pane(Look::Alpha::blended, 0.5f)).middle()[0]);
  EXPECT_EQ(PaneOverFloor(blue_pane(Look::Alpha::ignored, 0.1f)).middle(), pane);
}

TEST(SeeThrough, TransmittedLightTakesTheColourOfTheGlass) {
  Look glass;
  glass.transmission = 1;
  PaneOverFloor clear(glass);
  const auto through = clear.middle(), bare = clear.bare();
  EXPECT_GT(through[0], 0.8 * bare[0]);
  glass.color = {0.1f, 1, 1};
  EXPECT_LT(PaneOverFloor(glass).middle()[0], 0.6 * through[0]);
}

TEST(SeeThrough, IsTheSameOnAnyNumberOfThreads) {
  const PaneOverFloor scene(blue_pane(Look::Alpha::blended, 0.5f), 3);
  Context one, many;
  one.threads = 1;
  many.threads = 3;
  EXPECT_EQ(render_picture(scene.mesh, nullptr, scene.options, one).rgb,
            render_picture(scene.mesh, nullptr, scene.options, many).rgb);
}

}  // namespace
}  // namespace craze::render
