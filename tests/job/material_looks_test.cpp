#include "craze/job/material_looks.h"
#include "craze/output/source_file.h"

#include <gtest/gtest.h>

#include "craze/render/png.h"
#include "temporary_folder.h"

namespace craze {
namespace {

/// A PNG of one colour.
void write_color(const std::filesystem::path& path, std::uint8_t r, std::uint8_t g,
                 std::uint8_t b) {
  render::write_png(path.string(), {1, 1, {r, g, b}});
}

std::vector<render::Look> shown(const std::vector<MaterialLook>& looks, const std::string& input,
                                std::vector<std::string>& said) {
  return material_looks(looks, input, said, {});
}

TEST(MaterialLooks, TexturesAreFoundBesideTheInput) {
  const TemporaryFolder folder;
  write_color(folder / "red.png", 255, 0, 0);
  MaterialLook look;
  look.base_picture.file = "red.png";
  std::vector<std::string> said;
  const auto looks = shown({look, look}, (folder / "a.ply").string(), said);
  ASSERT_EQ(looks.size(), 2u);
  EXPECT_EQ(looks[0].picture.texture, looks[1].picture.texture) << "decoded once";
  EXPECT_LT((looks[0].at({0, 0}).color - render::Rgb(1, 0, 0)).abs().maxCoeff(), 1e-6);
  EXPECT_TRUE(said.empty());
}

TEST(MaterialLooks, WhatCannotBeShownIsSaidOnce) {
  const TemporaryFolder folder;
  MaterialLook missing;
  missing.base_picture.file = "missing.png";
  MaterialLook broken;
  broken.base_picture.bytes = std::make_shared<const std::string>("no picture");
  broken.base_color = {0.5f, 0.25f, 0, 1};
  std::vector<std::string> said;
  const auto looks = shown({missing, missing, broken}, (folder / "a.glb").string(), said);
  ASSERT_EQ(looks.size(), 3u);
  EXPECT_EQ(said.size(), 2u);
  EXPECT_FALSE(looks[2].picture);
  EXPECT_EQ(looks[2].color[1], 0.25f);
}

TEST(MaterialLooks, TexturesInFurtherUvsAreShownOrSaidToBeLeftOut) {
  const TemporaryFolder folder;
  write_color(folder / "red.png", 255, 0, 0);
  const std::string input = (folder / "a.gltf").string();
  MaterialLook look;
  LookPicture red;
  red.file = "red.png";
  look.further.push_back({&MaterialLook::base_picture, red, 2});
  std::vector<std::string> said;
  EXPECT_TRUE(shown({look, look}, input, said).empty());
  EXPECT_EQ(said.size(), 1u);
  const auto all = material_looks({look}, input, said, {}, ShownUvs::all);
  EXPECT_EQ(said.size(), 1u);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].picture.uv_set, 2u);
  EXPECT_LT((all[0].at({0, 0}).color - render::Rgb(1, 0, 0)).abs().maxCoeff(), 1e-6);
}

TEST(MaterialLooks, TransmissionOfAFurtherUvSetHasItsFactor) {
  const TemporaryFolder folder;
  write_color(folder / "half.png", 128, 0, 0);
  MaterialLook look;
  LookPicture half;
  half.file = "half.png";
  look.further.push_back({&MaterialLook::transmission_picture, half, 1, 0.5f});
  std::vector<std::string> said;
  const auto all = material_looks({look}, (folder / "a.gltf").string(), said, {}, ShownUvs::all);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].at({0, 0}).transmission, 0.5 * 128 / 255, 1e-6);
}

TEST(MaterialLooks, GreyWithoutTexturesSaysNothing) {
  MaterialLook grey;
  grey.base_color = {0.8f, 0.8f, 0.8f, 1};
  std::vector<std::string> said;
  EXPECT_TRUE(shown({grey, {}}, "a.glb", said).empty());
  MaterialLook red = grey;
  red.base_color[0] = 1;
  EXPECT_EQ(shown({grey, red}, "a.glb", said).size(), 2u);
  MaterialLook glass = grey;
  glass.alpha = MaterialLook::Alpha::blended;
  glass.base_color[3] = 0.25f;
  const auto looks = shown({grey, glass}, "a.glb", said);
  ASSERT_EQ(looks.size(), 2u);
  EXPECT_TRUE(looks[1].is_see_through());
  EXPECT_EQ(looks[1].at_factor().cover, 0.25f);
}

TEST(MaterialLooks, FilesAreNamedFromTheOutput) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "in/maps");
  std::filesystem::create_directories(folder / "out");
  MaterialLook look;
  look.base_picture.file = "maps/a.png";
  const auto seen =
      looks_from({look}, (folder / "in/a.gltf").string(), (folder / "out/b.usda").string());
  EXPECT_EQ(seen[0].base_picture.file, "../in/maps/a.png");
  look.base_picture.file = "my%20maps/a%.png";
  look.normal_picture.file = "https://somewhere/a%20b.png";
  const auto encoded = looks_from({look}, "in.gltf", "no_such_file.usda");
  EXPECT_EQ(encoded[0].base_picture.file, "my maps/a%.png");
  EXPECT_EQ(encoded[0].normal_picture.file, look.normal_picture.file);
}

}  // namespace
}  // namespace craze
