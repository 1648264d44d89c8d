#include "craze/products/maps/texel_owners.h"

#include <gtest/gtest.h>

#include "plates.h"

namespace craze {
namespace {

std::vector<PlacedPiece> all_pieces(const MapSurface& maps) {
  std::vector<PlacedPiece> placed;
  for (std::size_t i = 0; i < maps.pieces.size(); ++i) {
    placed.push_back({static_cast<std::int32_t>(i), Vec2::Zero()});
  }
  return placed;
}

/// The plate's UVs turned and shrunk, so that no edge follows the texels.
MapSurface turned_plate(int n) {
  MapSurface maps = plate_with(n, {});
  for (MapPiece& piece : maps.pieces) {
    for (Vec2& uv : piece.uvs) {
      const Vec2 d = uv - Vec2(0.5, 0.5);
      uv = Vec2(0.48, 0.53) + Vec2(0.49 * d.x() - 0.31 * d.y(), 0.31 * d.x() + 0.49 * d.y());
    }
  }
  return maps;
}

TEST(TexelOwners, GiveEachTexelToOnePieceAndLeaveNoneBetweenThem) {
  for (const int size : {1, 2, 37, 256}) {
    const MapSurface plate = plate_with(11, {});
    const TexelOwners owners(plate.pieces, all_pieces(plate), size);
    EXPECT_EQ(owners.covered(), static_cast<std::int64_t>(size) * size);
    EXPECT_EQ(owners.overlapping(), 0);
  }
  const MapSurface turned = turned_plate(13);
  const TexelOwners owners(turned.pieces, all_pieces(turned), 500);
  EXPECT_EQ(owners.overlapping(), 0);
  const double area = 0.49 * 0.49 + 0.31 * 0.31;
  EXPECT_NEAR(static_cast<double>(owners.covered()), area * 500 * 500, 500);
}

TEST(TexelOwners, GiveTexelsOutsideToTheNearestOneInside) {
  const int size = 60;
  const MapSurface maps = turned_plate(3);
  const TexelOwners owners(maps.pieces, all_pieces(maps), size);
  std::vector<std::vector<TexelOwners::Owner>> rows(size);
  for (int y = 0; y < size; ++y) owners.row(y, rows[y]);
  const auto is_inside = [&](int x, int y) { return rows[y][x].x == x && rows[y][x].y == y; };
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      int nearest = size * size;
      for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
          if (is_inside(i, j)) nearest = std::min(nearest, (i - x) * (i - x) + (j - y) * (j - y));
        }
      }
      const TexelOwners::Owner& owner = rows[y][x];
      ASSERT_TRUE(is_inside(owner.x, owner.y));
      const int dx = owner.x - x, dy = owner.y - y;
      ASSERT_EQ(dx * dx + dy * dy, nearest) << x << " " << y;
      ASSERT_EQ(owner.placed, rows[owner.y][owner.x].placed);
    }
  }
}

TEST(TexelOwners, GivePiecesSmallerThanATexelTheOneAroundThem) {
  MapSurface maps = plate_with(1, {});
  for (MapPiece& piece : maps.pieces) {
    for (Vec2& uv : piece.uvs) uv = Vec2(0.61, 0.23) + 1e-3 * uv;
  }
  const TexelOwners owners(maps.pieces, all_pieces(maps), 8);
  EXPECT_EQ(owners.covered(), 1);
  std::vector<TexelOwners::Owner> row;
  owners.row(6, row);
  EXPECT_EQ(row[4].placed, 0);
  EXPECT_EQ(row[0].x, 4);
}

TEST(TexelOwners, CountTexelsThatTwoPiecesAskFor) {
  const MapSurface plate = plate_with(2, {});
  std::vector<PlacedPiece> twice = all_pieces(plate);
  for (const PlacedPiece& placed : all_pieces(plate)) twice.push_back(placed);
  const TexelOwners owners(plate.pieces, twice, 32);
  EXPECT_EQ(owners.covered(), 32 * 32);
  EXPECT_EQ(owners.overlapping(), 32 * 32);
}

}  // namespace
}  // namespace craze
