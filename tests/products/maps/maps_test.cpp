#include <gtest/gtest.h>

#include <set>

#include "craze/error.h"
#include "height_and_normal.h"
#include "plates.h"

namespace craze {
namespace {

TEST(Maps, DistanceIsThatToTheNearestCurveAtEveryTexel) {
  const int size = 150;
  for (const int n : {1, 7, 23}) {
    const MapSurface plate = plate_with(n, known_cracks());
    const Map distance = bake(plate, options_of(size, {MapKind::distance})).front();
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        double nearest = 10;
        for (const MapCrack& crack : plate.cracks) {
          nearest = std::min(nearest, distance_to(crack, middle(x, y, size)));
        }
        ASSERT_NEAR(distance.values[y * size + x], nearest, 1e-6) << n << ": " << x << " " << y;
      }
    }
  }
}

TEST(Maps, MaskCoversWhatTheOpenCracksCover) {
  const int parts = 8;
  for (const int size : {40, 150}) {
    const MapSurface plate = plate_with(7, known_cracks());
    const Map mask = bake(plate, options_of(size, {MapKind::mask})).front();
    double baked = 0, exact = 0, worst = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        int inside = 0;
        for (int part = 0; part < parts * parts; ++part) {
          const Vec3 p((x + (part % parts + 0.5) / parts) / size,
                       1 - (y + (part / parts + 0.5) / parts) / size, 0);
          inside += std::any_of(plate.cracks.begin(), plate.cracks.end(),
                                [&](const MapCrack& crack) { return is_in(crack, p); });
        }
        const double share = static_cast<double>(inside) / (parts * parts);
        baked += mask.values[y * size + x];
        exact += share;
        worst = std::max(worst, std::abs(share - mask.values[y * size + x]));
      }
    }
    EXPECT_NEAR(baked / exact, 1, 0.01) << size;
    EXPECT_LT(worst, 0.1) << size;
  }
}

TEST(Maps, LinesFarThinnerThanATexelKeepTheirArea) {
  const int size = 64;
  const double width = 0.1 / size;
  const MapSurface plate = plate_with(5, {crack_from(0, 0.213, 1, 0.717, width, width)});
  const Map mask = bake(plate, options_of(size, {MapKind::mask})).front();
  const double length = (plate.cracks[0].b - plate.cracks[0].a).norm();
  const double area = std::accumulate(mask.values.begin(), mask.values.end(), 0.0) / (size * size);
  EXPECT_NEAR(area, width * length, 0.01 * width * length);
}

TEST(Maps, NormalIsTheGradientOfTheHeight) {
  const int size = 200;
  const MapSurface plate = plate_with(9, known_cracks());
  const std::vector<Map> maps = bake(plate, options_of(size, {MapKind::height, MapKind::normal}));
  EXPECT_LT(test::largest_tilt(maps[0], maps[1], size), 1);
}

TEST(Maps, HeightIsTheGrooveFromItsRimsDownToItsLine) {
  const int size = 500;
  const double width = 0.2, wall = 0.03;
  const MapSurface plate = plate_with(4, {crack_from(0, 0.5, 1, 0.5, width, width)});
  MapOptions options = options_of(size, {MapKind::height});
  options.post.wall = wall;
  const Map height = bake(plate, options).front();
  for (int y = 0; y < size; ++y) {
    const double d = std::abs(middle(0, y, size).y() - 0.5);
    // Averaging over the texel rounds the bottom and the rims.
    EXPECT_NEAR(height.values[y * size + size / 2], -wall * std::max(0.0, 1 - 2 * d / width),
                wall / width / size)
        << y;
  }
}

TEST(Maps, GreenPointsUpOrDownAsAsked) {
  const MapSurface plate = plate_with(5, known_cracks());
  MapOptions options = options_of(100, {MapKind::normal});
  const Map up = bake(plate, options).front();
  options.green_up = false;
  const Map down = bake(plate, options).front();
  bool differs = false;
  for (std::size_t i = 0; i < up.values.size(); ++i) {
    ASSERT_FLOAT_EQ(down.values[i], i % 3 == 1 ? 1 - up.values[i] : up.values[i]);
    differs |= down.values[i] != up.values[i];
  }
  EXPECT_TRUE(differs);
}

TEST(Maps, AreTheSameBytesOnAnyNumberOfThreads) {
  const MapSurface plate = plate_with(9, known_cracks());
  const std::vector<Map> one = bake(plate, options_of(130, {}), 1);
  const std::vector<Map> three = bake(plate, options_of(130, {}), 3);
  ASSERT_EQ(one.size(), map_table().size());
  for (std::size_t m = 0; m < one.size(); ++m) {
    EXPECT_EQ(one[m].values, three[m].values) << map_info(one[m].header.kind).name;
  }
}

TEST(Maps, StayInTheRangeThatTheyAreSaidToHave) {
  const MapSurface plate = plate_with(9, known_cracks());
  for (const Map& map : bake(plate, options_of(200, {}))) {
    if (map.header.kind == MapKind::curvature) continue;  // its sharpest rims are cut off
    const int channels = map_info(map.header.kind).channels;
    for (std::size_t i = 0; i < map.values.size(); ++i) {
      const auto c = i % static_cast<std::size_t>(channels);
      // A texel outside the surface shows what would follow.
      const double slack = 1e-6 + (map.header.kind == MapKind::position ? 2.0 / 200 : 0);
      ASSERT_GE(map.values[i], map.header.low[c] - slack) << map_info(map.header.kind).name;
      ASSERT_LE(map.values[i], map.header.high[c] + slack) << map_info(map.header.kind).name;
    }
  }
}

TEST(Maps, OfAPlateWithoutCracksAreFlat) {
  for (const Map& map : bake(plate_with(3, {}), options_of(20, {}))) {
    if (map.header.kind == MapKind::position) continue;
    const std::size_t channels = map_info(map.header.kind).channels;
    for (std::size_t i = channels; i < map.values.size(); ++i) {
      ASSERT_EQ(map.values[i], map.values[i - channels]) << map_info(map.header.kind).name;
    }
  }
}

TEST(Maps, CracksAreAtMostAsWideAsTheyAreApart) {
  const MapSurface plate = plate_with(7, known_cracks());
  double length = 0;
  for (const MapCrack& crack : plate.cracks) length += (crack.b - crack.a).norm();
  for (const double gap : {1e3, 1e300}) {
    MapOptions options = options_of(32, {MapKind::width});
    options.post.gap = gap;
    std::vector<Map> made;
    MapsInMemory sink(made);
    const auto said = bake_surface(plate, options, sink, {});
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("post.gap_width asks for more"), std::string::npos) << said[0];
    const auto& widths = made.at(0).values;
    EXPECT_NEAR(*std::max_element(widths.begin(), widths.end()), 2 / length, 1e-6) << gap;
  }
}

TEST(Maps, WithoutCracksTheySaySo) {
  std::vector<Map> made;
  MapsInMemory sink(made);
  const auto said = bake_surface(plate_with(3, {}), options_of(8, {MapKind::mask}), sink, {});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("no cracks that lie shut"), std::string::npos);
}

TEST(Maps, IdsAreNeverMixed) {
  MapSurface plate = plate_with(9, known_cracks());
  for (MapPiece& piece : plate.pieces) piece.fragment = piece.face % 5 == 0 ? 7 : 70;
  for (std::size_t i = 0; i < plate.cracks.size(); ++i) {
    plate.cracks[i].number = static_cast<std::int32_t>(100 * i);
  }
  const std::vector<Map> maps = bake(plate, options_of(90, {MapKind::fragment, MapKind::crack}));
  const std::set<float> fragments(maps[0].values.begin(), maps[0].values.end());
  const std::set<float> cracks(maps[1].values.begin(), maps[1].values.end());
  EXPECT_EQ(fragments, (std::set<float>{8, 71}));
  EXPECT_EQ(cracks, (std::set<float>{1, 101, 201, 301}));
}

TEST(Maps, RefuseWhatIsNoMap) {
  EXPECT_EQ(find_map("occlusion"), MapKind::occlusion);
  EXPECT_THROW(find_map("oclusion"), Error);
  MapOptions options = options_of(16, {MapKind::mask, MapKind::mask});
  EXPECT_THROW(bake(plate_with(1, {}), options), Error);
  EXPECT_THROW(bake(plate_with(1, {}), options_of(0, {})), Error);
  EXPECT_THROW(bake(plate_with(1, {}), options_of(8193, {})), Error);
}

TEST(Maps, AreStoppedWhenAsked) {
  std::vector<Map> maps;
  MapsInMemory sink(maps);
  Context context;
  context.cancelled = [] { return true; };
  EXPECT_THROW(bake_surface(plate_with(3, known_cracks()), options_of(64, {}), sink, context),
               Cancelled);
}

}  // namespace
}  // namespace craze
