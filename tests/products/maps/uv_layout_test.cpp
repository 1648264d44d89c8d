#include "craze/products/maps/uv_layout.h"

#include <gtest/gtest.h>

#include "plates.h"

namespace craze {
namespace {

void move_uvs(MapSurface& maps, std::int32_t face, const Vec2& by, double scale) {
  MapPiece& piece = maps.pieces[face];
  for (int i = 0; i < 3; ++i) {
    piece.uvs[i] = scale * piece.uvs[i] + by;
    maps.surface.corner_uvs[3 * static_cast<std::size_t>(face) + i] = piece.uvs[i];
  }
}

/// Two plates' worth of faces: the lower half of them of material 0, the others of material 1.
MapSurface two_materials(const Vec2& second_at, double scale) {
  MapSurface maps = plate_with(4, {});
  maps.surface.material_names = {"clay/red", "clay:red"};
  const auto faces = static_cast<std::int32_t>(maps.pieces.size());
  for (std::int32_t f = 0; f < faces; ++f) {
    const bool second = f >= faces / 2;
    maps.surface.face_materials.push_back(second ? 1 : 0);
    move_uvs(maps, f, second ? second_at : Vec2(0, 0), scale);
  }
  return maps;
}

TEST(UvLayout, IsOneSetWhereMaterialsLieApart) {
  const UvLayout layout = uv_layout(two_materials({0, 0}, 1), false, {});
  ASSERT_EQ(layout.sheets.size(), 1u);
  EXPECT_EQ(layout.sheets[0].texture_set, "");
  EXPECT_EQ(layout.sheets[0].udim, 0);
  EXPECT_TRUE(layout.warnings.empty());
}

TEST(UvLayout, IsASetPerMaterialWhereTheyShareThePicture) {
  const UvLayout layout = uv_layout(two_materials({0, -0.5}, 1), false, {});
  ASSERT_EQ(layout.sheets.size(), 2u);
  // Names that files can have, each its own.
  EXPECT_EQ(layout.sheets[0].texture_set, "clay_red");
  EXPECT_EQ(layout.sheets[1].texture_set, "clay_red_2");
  EXPECT_TRUE(layout.warnings.empty());
}

TEST(UvLayout, HasTilesWhereEachPieceLiesInOne) {
  const UvLayout layout = uv_layout(two_materials({1, 1}, 1), false, {});
  ASSERT_EQ(layout.sheets.size(), 2u);
  EXPECT_EQ(layout.sheets[0].udim, 1001);
  EXPECT_EQ(layout.sheets[1].udim, 1012);
  EXPECT_EQ(layout.sheets[1].pieces.front().offset, Vec2(1, 1));
}

TEST(UvLayout, RepeatsWhatLeavesTheSquareOtherwise) {
  MapSurface maps = plate_with(1, {});
  for (std::int32_t f = 0; f < 2; ++f) move_uvs(maps, f, {0.5, 0}, 1);
  const UvLayout layout = uv_layout(maps, false, {});
  ASSERT_EQ(layout.sheets.size(), 1u);
  EXPECT_EQ(layout.sheets[0].udim, 0);
  EXPECT_EQ(layout.sheets[0].pieces.size(), 4u);
  EXPECT_TRUE(layout.warnings.empty());
}

TEST(UvLayout, UvsThatRepeatWithoutEndAreOverlapAtOnce) {
  for (const double scale : {100.0, 1e4, 1e30, 1e200}) {
    MapSurface maps = plate_with(40, {});
    for (std::int32_t f = 0; f < static_cast<std::int32_t>(maps.pieces.size()); ++f) {
      move_uvs(maps, f, {0.1, 0.2}, scale);
    }
    const UvLayout layout = uv_layout(maps, false, {});
    ASSERT_EQ(layout.sheets.size(), 1u) << scale;
    EXPECT_EQ(layout.sheets[0].pieces.size(), maps.pieces.size()) << scale;
    EXPECT_EQ(overlap_of(maps, layout.sheets), 1) << scale;
    EXPECT_EQ(layout.warnings.size(), 1u) << scale;
  }
}

TEST(UvLayout, WarnsOfOverlapThatMaterialsDoNotExplain) {
  MapSurface maps = plate_with(4, {});
  const auto half = static_cast<std::int32_t>(maps.pieces.size() / 2);
  for (std::int32_t f = half; f < 2 * half; ++f) move_uvs(maps, f, {0, -0.5}, 1);
  const UvLayout layout = uv_layout(maps, false, {});
  EXPECT_EQ(layout.sheets.size(), 1u);
  ASSERT_EQ(layout.warnings.size(), 1u);
  EXPECT_NE(layout.warnings[0].find("overlap"), std::string::npos);
}

}  // namespace
}  // namespace craze
