// What both sides of a seam of the UVs show.
#include <gtest/gtest.h>

#include "craze/products/maps/uv_layout.h"
#include "plates.h"

namespace craze {
namespace {

/// Where the two halves of the plate lie in the UVs: apart, the right one turned and smaller.
Vec2 left_uv(const Vec3& p) {
  return {0.05 + 0.83 * p.x(), 0.04 + 0.9 * p.y()};
}
Vec2 right_uv(const Vec3& p) {
  const Vec2 d = 0.6 * Vec2(p.x() - 0.75, p.y() - 0.5);
  return Vec2(0.74, 0.5) + Vec2(0.95 * d.x() - 0.31225 * d.y(), 0.31225 * d.x() + 0.95 * d.y());
}

/// The plate cut into two islands along x = 1/2.
MapSurface plate_of_two_islands(int n) {
  MapSurface maps = plate_with(n, known_cracks());
  for (MapPiece& piece : maps.pieces) {
    const Triangle& t = maps.surface.triangles[piece.face];
    double x = 0;
    for (const std::int32_t v : t) x += maps.surface.positions[v].x() / 3;
    for (int i = 0; i < 3; ++i) {
      const Vec3& p = maps.surface.positions[t[i]];
      piece.uvs[i] = x < 0.5 ? left_uv(p) : right_uv(p);
      maps.surface.corner_uvs[3 * static_cast<std::size_t>(piece.face) + i] = piece.uvs[i];
    }
  }
  return maps;
}

/// As a graphics card reads it.
double bilinear(const Map& map, int channel, const Vec2& uv) {
  const int size = map.header.size, channels = map_info(map.header.kind).channels;
  const double x = uv.x() * size - 0.5, y = (1 - uv.y()) * size - 0.5;
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const auto at = [&](int column, int row) -> double {
    return map.values[(static_cast<std::size_t>(row) * size + column) * channels + channel];
  };
  const double s = x - i, t = y - j;
  return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) +
         t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
}

TEST(SeamsOfMaps, ShowOnePlaceFromBothSides) {
  const int size = 256, samples = 2000;
  const MapSurface maps = plate_of_two_islands(8);
  const std::vector<Map> baked =
      bake(maps, options_of(size, {MapKind::position, MapKind::distance, MapKind::height}));
  double distance = 0, height = 0;
  for (int i = 0; i < samples; ++i) {
    const Vec3 p(0.5, (i + 0.5) / samples, 0);
    for (int c = 0; c < 2; ++c) {
      const double step = 1.0 / 65535;
      ASSERT_NEAR(bilinear(baked[0], c, left_uv(p)), p[c], step);
      ASSERT_NEAR(bilinear(baked[0], c, right_uv(p)), p[c], step);
    }
    const auto apart = [&](const Map& map) {
      return std::abs(bilinear(map, 0, left_uv(p)) - bilinear(map, 0, right_uv(p)));
    };
    distance = std::max(distance, apart(baked[1]));
    height = std::max(height, apart(baked[2]));
  }
  // Texels of the right island are 1/154 large; only kinks are drawn differently on two grids.
  const double texel = 1 / (0.6 * size);
  EXPECT_LT(distance, 0.3 * texel);
  const double slope = 2 * 0.02 / 0.03;  // of the steepest wall at the seam
  EXPECT_LT(height, 0.3 * texel * slope);
}

TEST(SeamsOfMaps, ShowOneCurledPieceFromBothSides) {
  const int size = 256, samples = 2000;
  MapSurface maps = plate_of_two_islands(8);
  // Cracked along y = 1/2, from side to side.
  TriangleMesh cut(maps.surface.positions, maps.surface.triangles);
  maps.cracks.clear();
  for (std::int32_t h = 0; h < 3 * cut.face_count(); ++h) {
    const Vec3 a = cut.position(cut.from(h)), b = cut.position(cut.to(h));
    if (cut.is_open(h) || a.y() != 0.5 || b.y() != 0.5 || b.x() < a.x()) continue;
    MapCrack crack = crack_from(a.x(), a.y(), b.x(), b.y(), 0.04, 0.04);
    crack.face = h / 3;
    crack.roots = {cut.root(cut.from(h)), cut.root(cut.to(h))};
    maps.cracks.push_back(crack);
    cut.cut(h, 0);
  }
  ASSERT_EQ(maps.cracks.size(), 8U);
  maps.cut = std::make_shared<const TriangleMesh>(std::move(cut));
  MapOptions options = options_of(size, {MapKind::height});
  options.post.curl = 1;
  const Map height = bake(maps, options).front();
  double apart = 0;
  for (int i = 0; i < samples; ++i) {
    const Vec3 p(0.5, (i + 0.5) / samples, 0);
    if (std::abs(p.y() - 0.5) < 0.03) continue;  // of the groove the test above tells
    EXPECT_GT(bilinear(height, 0, left_uv(p)), 0);
    apart = std::max(apart,
                     std::abs(bilinear(height, 0, left_uv(p)) - bilinear(height, 0, right_uv(p))));
  }
  // The curvature of the lift over a texel, of 1/154 of the plate.
  EXPECT_LT(apart, 2e-4 * 0.02);
}

TEST(SeamsOfMaps, HaveTheFacesOnBothSidesAtTheBorder) {
  const MapSurface maps = plate_of_two_islands(8);
  const std::vector<std::uint8_t> at_border = faces_at_uv_border(maps.surface);
  for (std::size_t f = 0; f < at_border.size(); ++f) {
    bool wanted = false;
    for (const std::int32_t v : maps.surface.triangles[f]) {
      const Vec3& p = maps.surface.positions[v];
      wanted |= p.x() == 0 || p.x() == 0.5 || p.x() == 1 || p.y() == 0 || p.y() == 1;
    }
    EXPECT_EQ(at_border[f] != 0, wanted) << f;
  }
}

}  // namespace
}  // namespace craze
