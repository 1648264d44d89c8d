// Maps of cracks whose lines are rough.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "craze/base/segment_distance.h"
#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/maps.h"
#include "craze/presets.h"
#include "craze/shapes.h"
#include "engine/tiles.h"
#include "height_and_normal.h"

namespace craze {
namespace {

constexpr int map_size = 300;

/// The unit plate around the origin.
Result rough_plate() {
  Recipe recipe = read_preset("mud");
  recipe.simulation.layer.spacing = 0.2;
  recipe.post.roughness = 0.01;
  const std::string shape = "plate?n=30&jitter=0.3";
  return crack({std::make_shared<SurfaceMesh>(make_shape(shape)), {}, shape}, recipe, {}, {});
}

std::vector<Map> maps_of(const Result& result, std::vector<MapKind> kinds) {
  MapOptions options;
  options.size = map_size;
  options.maps = std::move(kinds);
  options.post.gap = 0.2;
  options.post.wall = 0.02;
  std::vector<std::string> warnings;
  return baked_maps(result, options, warnings, {});
}

TEST(RoughMaps, MeasureTheDistanceToTheRoughLines) {
  const Result result = rough_plate();
  const Map distance = maps_of(result, {MapKind::distance}).front();
  const CrackNetwork& network = result.state().network;
  double worst = 0;
  for (int y = 0; y < map_size; y += 13) {
    for (int x = 0; x < map_size; x += 13) {
      const Vec3 p((x + 0.5) / map_size - 0.5, 0.5 - (y + 0.5) / map_size, 0);
      double least = 2;
      for (const CrackEdge& e : network.edges) {
        least = std::min(least, point_segment_distance(p, network.nodes[e.a].position,
                                                       network.nodes[e.b].position));
      }
      worst = std::max(
          worst, std::abs(distance.values[static_cast<std::size_t>(y * map_size + x)] - least));
    }
  }
  EXPECT_LT(worst, 1e-6);
}

TEST(RoughMaps, HaveTheGradientOfTheHeightAsTheirNormal) {
  const std::vector<Map> maps = maps_of(rough_plate(), {MapKind::height, MapKind::normal});
  EXPECT_LT(test::largest_tilt(maps[0], maps[1], map_size), 1);
}

TEST(RoughMaps, OfATileHaveOneFragmentOnEachSideOfALine) {
  const CrackedTile smooth = mud_tile(0.25, 3), rough = rough_mud_tile(0.25, 3, 0.01);
  EXPECT_EQ(rough.fragments.count, smooth.fragments.count);
  EXPECT_NEAR(rough.mesh().total_area(), 1, 1e-9);
  EXPECT_GT(rough.report.cracks.length, 1.005 * smooth.report.cracks.length);
}

}  // namespace
}  // namespace craze
