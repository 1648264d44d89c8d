// Tiles: patterns on a flat torus.
#include "craze/engine/tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/error.h"
#include "craze/shapes.h"
#include "engine/tiles.h"
#include "error_message.h"

namespace craze {
namespace {

double area_of(const TriangleMesh& mesh) {
  double area = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) area += mesh.area(f);
  return area;
}

TEST(Tile, IsATorusOfTheAreaOfItsSquareBeforeAndAfterItIsCut) {
  const CrackedTile tile = mud_tile(0.2, 1);
  const TriangleMesh before(tile.surface.positions, tile.surface.triangles, {1});
  std::int32_t open = 0, edges = 0;
  for (std::int32_t h = 0; h < 3 * before.face_count(); ++h) {
    open += before.is_open(h);
    edges += before.opposite(h) < h;
    EXPECT_LT(before.way(before.from(h), before.to(h)).norm(), 0.25);
  }
  EXPECT_EQ(open, 0);
  EXPECT_EQ(before.vertex_count() - edges + before.face_count(), 0);  // Euler, genus 1
  EXPECT_NEAR(area_of(before), 1, 1e-12);
  EXPECT_NEAR(area_of(tile.simulation->mesh()), 1, 1e-12);
  EXPECT_GT(tile.report.cracks.fragments, 10);
}

TEST(Tile, HasCracksThatRunOverItsSides) {
  const CrackedTile tile = mud_tile(0.2, 2);
  int over = 0;
  for (const CrackEdge& e : tile.network.edges) {
    const Vec3 apart = tile.network.nodes[e.b].position - tile.network.nodes[e.a].position;
    EXPECT_LT(tile.network.length(e), 0.1);
    over += apart.norm() > 0.5;
  }
  EXPECT_GT(over, 4);  // at five pieces a side, some ten cracks cross the two
}

TEST(Tile, IsTheSameOnAnyNumberOfThreads) {
  Context one, three;
  one.threads = 1;
  three.threads = 3;
  const CrackedTile a = mud_tile(0.2, 3, one), b = mud_tile(0.2, 3, three);
  ASSERT_EQ(a.network.nodes.size(), b.network.nodes.size());
  for (std::size_t n = 0; n < a.network.nodes.size(); ++n) {
    ASSERT_EQ(a.network.nodes[n].position, b.network.nodes[n].position);
  }
  EXPECT_EQ(a.fragments.face, b.fragments.face);
}

TEST(Tile, IsRefusedInOneLineWhereItHasNotWhatTheRecipeAsksFor) {
  const auto error = [](Recipe recipe, double side) {
    return error_of([&] { crack_tile(recipe, {side, 0}, {}); });
  };
  Recipe recipe = mud_for_tiles(0.9, 1);
  EXPECT_NE(error(recipe, 1).find("tile too small for its pattern"), std::string::npos);
  EXPECT_NE(error(recipe, 0).find("bad tile"), std::string::npos);
  recipe = mud_for_tiles(0.2, 1);
  recipe.simulation.stress.attribute = "drying";
  EXPECT_NE(error(recipe, 1).find("drying"), std::string::npos);
}

/// Length of cracks and junctions of three in a square of the plane.
struct TilePattern {
  double length = 0, junctions = 0;
};

/// Length of the part of a segment that lies in the square [low, low + 1]².
double length_inside(const Vec3& a, const Vec3& b, double low) {
  double from = 0, to = 1;
  for (int k = 0; k < 2; ++k) {
    const double d = b[k] - a[k];
    if (d == 0) {
      if (a[k] < low || a[k] > low + 1) return 0;
      continue;
    }
    const double s = (low - a[k]) / d, t = (low + 1 - a[k]) / d;
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  return to > from ? (to - from) * (b - a).norm() : 0;
}

TilePattern inside(const CrackNetwork& network, double low) {
  TilePattern p;
  for (const CrackEdge& e : network.edges) {
    p.length += length_inside(network.nodes[e.a].position, network.nodes[e.b].position, low);
  }
  for (const CrackNode& n : network.nodes) {
    const Vec3 at = n.position - Vec3(low, low, 0);
    p.junctions +=
        n.kind == JunctionKind::junction && at.x() >= 0 && at.x() < 1 && at.y() >= 0 && at.y() < 1;
  }
  return p;
}

TilePattern of_tile(const CrackNetwork& network) {
  TilePattern p;
  p.length = total_length(network);
  for (const CrackNode& n : network.nodes) p.junctions += n.kind == JunctionKind::junction;
  return p;
}

/// Mean and its standard error.
struct Mean {
  double value = 0, error = 0;
};

Mean mean(const std::vector<double>& x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (const double v : x) sum += v;
  for (const double v : x) squares += (v - sum / n) * (v - sum / n);
  return {sum / n, std::sqrt(squares / (n - 1) / n)};
}

TEST(Tile, HasTheStatisticsOfTheInteriorOfALargePlate) {
  std::vector<double> tile_length, tile_junctions, plate_length, plate_junctions;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const TilePattern t = of_tile(mud_tile(0.125, seed).network);
    tile_length.push_back(t.length);
    tile_junctions.push_back(t.junctions);
    // 1.75 wide, so that the unit square in its middle is three pieces from the border.
    Input input;
    SurfaceMesh plate = make_shape("plate?n=20");
    const double across = -2 * plate.positions[0].x();
    for (Vec3& p : plate.positions) p *= 1.75 / across;
    input.surface = std::make_shared<const SurfaceMesh>(std::move(plate));
    Recipe recipe = mud_for_tiles(0.125, seed);
    recipe.mesh.output = OutputMesh::simulation;
    const Result result = crack(std::move(input), recipe, {}, {});
    const TilePattern p = inside(result.state().network, -0.5);
    plate_length.push_back(p.length);
    plate_junctions.push_back(p.junctions);
  }
  const auto compare = [](const Mean& tile, const Mean& plate, const char* what) {
    const double error = std::sqrt(tile.error * tile.error + plate.error * plate.error);
    EXPECT_LT(std::abs(tile.value - plate.value), 3 * error) << what;
    EXPECT_LT(error, 0.03 * plate.value) << what << " is not measured well enough";
  };
  compare(mean(tile_length), mean(plate_length), "length");
  compare(mean(tile_junctions), mean(plate_junctions), "junctions");
}

TEST(Tile, HasNoMoreCracksAlongItsSidesThanElsewhere) {
  const double band = 0.04;
  std::vector<double> share;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const CrackedTile tile = mud_tile(0.2, seed);
    const Period period{1};
    double near = 0;
    for (const CrackEdge& e : tile.network.edges) {
      const Vec3& a = tile.network.nodes[e.a].position;
      const Vec3 middle = period.wrapped(a + 0.5 * tile.network.way(e.a, e.b));
      const double x = std::min(middle.x(), 1 - middle.x());
      const double y = std::min(middle.y(), 1 - middle.y());
      if (std::min(x, y) < band) near += tile.network.length(e);
    }
    share.push_back(near / total_length(tile.network));
  }
  const Mean found = mean(share);
  const double of_area = 1 - (1 - 2 * band) * (1 - 2 * band);
  EXPECT_LT(std::abs(found.value - of_area), 3 * found.error);
  EXPECT_LT(found.error, 0.2 * of_area);
}

}  // namespace
}  // namespace craze
