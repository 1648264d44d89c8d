// post.curl in maps: lifted rims as heights and normals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "craze/engine.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/products/opening/bend_refinement.h"
#include "height_and_normal.h"
#include "plates.h"

namespace craze {
namespace {

constexpr double width = 0.04, curl = 0.5, wall = 0.02;

/// The unit plate in two halves with a crack along x = 1/2 between them, as a file has it.
SurfaceMesh halved_plate(int n) {
  SurfaceMesh mesh;
  for (int half = 0; half < 2; ++half) {
    const auto first = static_cast<std::int32_t>(mesh.positions.size());
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        mesh.positions.emplace_back((half + static_cast<double>(i) / n) / 2,
                                    static_cast<double>(j) / n, 0);
      }
    }
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const std::int32_t a = first + j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({a, d, c});
      }
    }
  }
  for (const Triangle& t : mesh.triangles) {
    for (const std::int32_t v : t) mesh.corner_uvs.push_back(mesh.positions[v].head<2>());
  }
  return mesh;
}

MapOptions curled(int size, std::vector<MapKind> kinds) {
  MapOptions options = options_of(size, std::move(kinds));
  options.post.gap = 0;
  options.post.gap_width = width;
  options.post.wall = wall;
  options.post.curl = curl;
  return options;
}

std::vector<Map> bake_of(const SurfaceMesh& mesh, const MapOptions& options) {
  return bake(map_surface(mesh, options.post, {}), options);
}

TEST(CurledMaps, FadeFromACrackAsTheScreenedEquationSays) {
  const int size = 256;
  const double length = 2.0 / 3;  // a third of 2 × area / length
  for (const int n : {1, 2, 40}) {
    SCOPED_TRACE(n);
    const std::vector<Map> maps =
        bake_of(halved_plate(n), curled(size, {MapKind::height, MapKind::normal}));
    const double rim = curl * width / 2;
    const double within = n < 10 ? bend_tolerance : 0.002;  // of coarse ones as they are refined to
    for (int x = 0; x < size; ++x) {
      const double d = std::abs(middle(x, 0, size).x() - 0.5);
      if (d < width / 2 + 1.0 / size) continue;
      const double lift = rim * std::cosh((0.5 - d) / length) / std::cosh(0.5 / length);
      for (const int y : {0, size / 3, size - 1}) {
        ASSERT_NEAR(maps[0].values[static_cast<std::size_t>(y * size + x)], lift, within * rim)
            << d << " at " << y;
      }
    }
    EXPECT_LT(test::largest_tilt(maps[0], maps[1], size), 1);
    EXPECT_NEAR(*std::min_element(maps[0].values.begin(), maps[0].values.end()), -wall,
                0.2 * (wall + rim));
    EXPECT_GE(maps[0].header.high[0], rim);
  }
}

TEST(CurledMaps, HaveAllThatTheyHaveWithoutWhereCurlIsZero) {
  const SurfaceMesh mesh = halved_plate(6);
  MapOptions flat = curled(64, {MapKind::height, MapKind::occlusion, MapKind::mask});
  MapOptions lifted = flat;
  flat.post.curl = 0;
  const std::vector<Map> without = bake_of(mesh, flat), with = bake_of(mesh, lifted);
  EXPECT_EQ(*std::max_element(without[0].values.begin(), without[0].values.end()), 0);
  EXPECT_EQ(without[2].values, with[2].values);  // as wide
  for (std::size_t i = 0; i < with[0].values.size(); ++i) {
    EXPECT_GE(with[0].values[i], without[0].values[i] - 1e-7F);
  }
}

Result mud_on(const char* shape) {
  Recipe recipe = read_preset("mud");
  recipe.simulation.layer.relative_spacing = 0.2;
  Input input;
  input.surface = std::make_shared<const SurfaceMesh>(make_shape(shape));
  return crack(std::move(input), recipe, {}, {});
}

/// Bilinear, at the middle of the map's own texels.
double value_at(const Map& map, const Vec2& uv) {
  const int size = map.header.size;
  const double x = uv.x() * size - 0.5, y = (1 - uv.y()) * size - 0.5;
  const int i = std::clamp(static_cast<int>(std::floor(x)), 0, size - 2),
            j = std::clamp(static_cast<int>(std::floor(y)), 0, size - 2);
  const auto at = [&](int column, int row) -> double {
    return map.values[static_cast<std::size_t>(row) * size + column];
  };
  const double s = x - i, t = y - j;
  return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) +
         t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
}

TEST(CurledMaps, LiftAsAnOpenedMeshDoes) {
  const Result result = mud_on("plate?n=60&jitter=0.3");
  PostParameters post;
  post.gap = 0.05;
  post.curl = 1;
  MapOptions options = options_of(512, {MapKind::height, MapKind::normal, MapKind::distance});
  options.post = post;
  std::vector<std::string> warnings;
  const std::vector<Map> maps = baked_maps(result, options, warnings, {});
  EXPECT_LT(test::largest_tilt(maps[0], maps[1], 512), 1);
  const SurfaceMesh opened = Opening(result, post, {}).mesh();
  const SurfaceMesh cut = cut_mesh(result, {});
  double lifts = 0, apart = 0;
  for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t v = cut.triangles[f][k];
      const Vec2& uv = cut.corner_uvs[3 * f + k];
      if (value_at(maps[2], uv) < 0.03) continue;  // away from grooves
      const double lift = opened.positions[v].z();
      lifts += lift;
      apart += std::abs(value_at(maps[0], uv) - lift);
    }
  }
  EXPECT_GT(lifts, 0);
  EXPECT_LT(apart, 0.15 * lifts);
}

TEST(CurledMaps, AreNoHigherNorDeeperThanTheSurfaceIsLarge) {
  const double diagonal = std::sqrt(2);
  for (const double huge : {1e3, 1e300, -1e300}) {
    MapOptions options = curled(64, {MapKind::height, MapKind::normal, MapKind::occlusion});
    options.post.curl = huge;
    options.post.wall = std::abs(huge);
    std::vector<Map> made;
    MapsInMemory sink(made);
    const std::vector<std::string> warnings =
        bake_surface(map_surface(halved_plate(8), options.post, {}), options, sink, {});
    EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                            [](const std::string& w) {
                              return w.find("as much as the surface is large") != std::string::npos;
                            }),
              2);
    for (const Map& map : made) {
      for (const float value : map.values) {
        ASSERT_TRUE(std::isfinite(value));
        ASSERT_LE(std::abs(value), 4 * diagonal);
      }
    }
  }
}

TEST(CurledMaps, OfAFileAreThoseOfTheRun) {
  const Result result = mud_on("cup?n=24");
  MapOptions options = options_of(128, {MapKind::height});
  options.post.gap = 0.05;
  options.post.curl = 2;
  std::vector<std::string> warnings;
  const Map of_run = baked_maps(result, options, warnings, {}).front();
  const Map of_file = bake_of(cut_mesh(result, {}), options).front();
  double sum = 0, apart = 0;
  for (std::size_t i = 0; i < of_run.values.size(); ++i) {
    sum += std::abs(of_run.values[i]);
    apart += std::abs(of_run.values[i] - of_file.values[i]);
  }
  EXPECT_GT(sum, 0);
  EXPECT_LT(apart, 0.04 * sum);  // a file has widths at vertices, a run along edges
}

}  // namespace
}  // namespace craze
