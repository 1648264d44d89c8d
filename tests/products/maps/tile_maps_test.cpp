// Maps of tiles: they continue on themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "craze/base/segment_distance.h"
#include "craze/maps.h"
#include "craze/products/maps/bake_surface.h"
#include "craze/products/maps/material_maps.h"
#include "craze/products/maps/tile_surface.h"
#include "engine/tiles.h"

namespace craze {
namespace {

MapOptions all_maps(int size) {
  MapOptions options;
  options.size = size;
  options.by_material = true;
  options.post.gap = 0.05;
  options.post.wall = 0.01;
  for (const MapInfo& info : map_table()) {
    if (info.kind != MapKind::position) options.maps.push_back(info.kind);
  }
  return options;
}

std::vector<Map> bake_tile(const MapSurface& surface, const MapOptions& options,
                           const Context& context = {}) {
  std::vector<Map> maps;
  MapsInMemory sink(maps);
  EXPECT_TRUE(bake_surface(surface, options, sink, context).empty());
  return maps;
}

/// The same tile of side 1 with its border elsewhere.
MapSurface moved(MapSurface maps, const Vec2& by) {
  SurfaceMesh& surface = maps.surface;
  std::vector<Vec2> shift;  // of each face
  SurfaceMesh laid = surface;
  laid.positions.clear();
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const Vec2 first = surface.corner_uvs[3 * f] + by;
    shift.push_back(by - Vec2(std::floor(first.x()), std::floor(first.y())));
    for (std::size_t i = 0; i < 3; ++i) {
      laid.corner_uvs[3 * f + i] += shift[f];
      laid.triangles[f][i] = static_cast<std::int32_t>(laid.positions.size());
      const Vec2& uv = laid.corner_uvs[3 * f + i];
      laid.positions.emplace_back(uv.x(), uv.y(), 0);
    }
  }
  surface = std::move(laid);
  for (MapPiece& piece : maps.pieces) {
    for (Vec2& uv : piece.uvs) uv += shift[static_cast<std::size_t>(piece.face)];
  }
  for (MapCrack& crack : maps.cracks) {
    const Vec2& s = shift[static_cast<std::size_t>(crack.face)];
    crack.a += Vec3(s.x(), s.y(), 0);
    crack.b += Vec3(s.x(), s.y(), 0);
  }
  return maps;
}

/// All maps of a tile of side 1 agree bit for bit with those of it cut open elsewhere.
void expect_no_border(const MapSurface& surface, std::uint64_t seed, double curl = 0,
                      double chipping = 0) {
  const int size = 64;
  MapOptions options = all_maps(size);
  options.post.curl = curl;
  options.post.chipping = chipping;
  const std::vector<Map> here = bake_tile(surface, options);
  const std::vector<Map> there = bake_tile(moved(surface, {0.5, 0.25}), options);
  for (std::size_t m = 0; m < here.size(); ++m) {
    const MapInfo& info = map_info(here[m].header.kind);
    const auto channels = static_cast<std::size_t>(info.channels);
    int different = 0;
    for (std::size_t y = 0; y < size; ++y) {
      for (std::size_t x = 0; x < size; ++x) {
        const std::size_t to_x = (x + size / 2) % size, to_y = (y + size - size / 4) % size;
        for (std::size_t c = 0; c < channels; ++c) {
          different += here[m].values[channels * (y * size + x) + c] !=
                       there[m].values[channels * (to_y * size + to_x) + c];
        }
      }
    }
    EXPECT_EQ(different, 0) << info.name << ", seed " << seed;
  }
}

TEST(MapsOfATile, AreTheSameBitForBitWhereverItsBorderLies) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    expect_no_border(tile_surface(mud_tile(0.25, seed)), seed);
  }
}

TEST(MapsOfATile, AreTheSameBitForBitWhereItsCracksAreRough) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    expect_no_border(tile_surface(rough_mud_tile(0.25, seed, 0.01)), seed);
  }
}

TEST(MapsOfATile, AreTheSameBitForBitWhereTheyCurlAndAreChipped) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    expect_no_border(tile_surface(mud_tile(0.25, seed)), seed, 2, 0.5);
  }
}

/// Between the distance map and the distances to all edges.
double worst_distance(const CrackedTile& tile, int size, int step) {
  MapOptions options = all_maps(size);
  options.maps = {MapKind::distance};
  const Map map = bake_tile(tile_surface(tile), options).front();
  double worst = 0;
  for (int y = 0; y < size; y += step) {
    for (int x = 0; x < size; x += step) {
      const Vec3 p((x + 0.5) / size, 1 - (y + 0.5) / size, 0);
      double least = 1;
      for (const CrackEdge& e : tile.network.edges) {
        const Vec3& node = tile.network.nodes[e.a].position;
        for (int i = -1; i <= 1; ++i) {
          for (int j = -1; j <= 1; ++j) {
            const Vec3 a = Period{1}.wrapped(node) + Vec3(i, j, 0);
            least = std::min(least, point_segment_distance(p, a, a + tile.network.way(e.a, e.b)));
          }
        }
      }
      const float found = map.values[static_cast<std::size_t>(y * size + x)];
      worst = std::max(worst, std::abs(static_cast<double>(found) - least));
    }
  }
  return worst;
}

TEST(MapsOfATile, MeasureTheDistanceToTheNearestImageOfACrack) {
  // Fine enough that texels beside a face do not hide what it misses.
  EXPECT_LT(worst_distance(mud_tile(0.25, 4), 400, 7), 1e-6);
  EXPECT_LT(worst_distance(rough_mud_tile(0.25, 4, 0.01), 400, 17), 1e-6);
}

TEST(MapsOfATile, AreTheSameOnAnyNumberOfThreads) {
  const MapSurface surface = tile_surface(mud_tile(0.25, 5));
  Context one, three;
  one.threads = 1;
  three.threads = 3;
  const std::vector<Map> a = bake_tile(surface, all_maps(150), one);
  const std::vector<Map> b = bake_tile(surface, all_maps(150), three);
  for (std::size_t m = 0; m < a.size(); ++m) EXPECT_EQ(a[m].values, b[m].values);
}

TEST(MaterialMaps, AddColourAndRoughnessToWhatWasAskedFor) {
  const int size = 64;
  TileMaterial material;
  material.color = {0.4f, 0.3f, 0.2f, 1};
  material.wall = {0.05f, 0.04f, 0.03f, 1};
  material.mottle = 0.2;
  material.pieces = 1;
  material.stain = 0.3;
  material.roughness = 0.5;
  const std::vector<MapKind> asked{MapKind::roughness, MapKind::mask, MapKind::base_color};
  std::vector<Map> maps;
  MapsInMemory sink(maps);
  const Context context;
  MaterialMaps with_material(material, 0.01, 1, asked, sink, context);
  MapOptions options = all_maps(size);
  options.maps = MaterialMaps::baked(asked);
  bake_surface(tile_surface(mud_tile(0.25, 6)), options, with_material, context);
  ASSERT_EQ(maps.size(), asked.size());
  int open = 0, whole = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size) * size; ++i) {
    const float roughness = maps[0].values[i], mask = maps[1].values[i];
    const float* color = &maps[2].values[3 * i];
    ASSERT_GE(roughness, mask);
    ASSERT_LE(roughness, 1);
    if (mask == 1) {
      ++open;
      ASSERT_EQ(roughness, 1);
      for (std::size_t c = 0; c < 3; ++c) ASSERT_FLOAT_EQ(color[c], material.wall[c]);
    } else if (mask == 0) {
      ++whole;
      ASSERT_NEAR(roughness, 0.5, 0.5 * 0.2);
      // One tint for all channels, by no more than clouds, pieces and stain together.
      ASSERT_NEAR(color[0] / material.color[0], color[2] / material.color[2], 1e-5);
      ASSERT_LT(color[0] / material.color[0], 1 + 0.2 + 0.08 + 1e-6);
      ASSERT_GT(color[0] / material.color[0], (1 - 0.2 - 0.08) * (1 - 0.3) - 1e-6);
    }
  }
  EXPECT_GT(open, 0);
  EXPECT_GT(whole, 1000);
}

}  // namespace
}  // namespace craze
