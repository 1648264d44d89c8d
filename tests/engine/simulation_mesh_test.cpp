// mesh.edge = "auto": the pattern is that of the object, not of its triangles.
#include <gtest/gtest.h>

#include "craze/engine.h"
#include "craze/products/cut_surface.h"
#include "craze/repair.h"
#include "engine/claims.h"
#include "engine/texture_shift.h"

namespace craze {
namespace {

constexpr double pi = std::numbers::pi;

struct Pattern {
  double spacing = 0, t_share = 0, angle = 0, anisotropy = 0, null = 0;
};

/// What a glaze makes of it, over three seeds.
Pattern pattern_of(const SurfaceMesh& mesh, const EdgeLength& edge) {
  Recipe recipe = read_preset("glaze");
  recipe.mesh.edge = edge;
  recipe.simulation.layer.relative_spacing = 0.14;
  Pattern mean;
  constexpr int seeds = 3;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const test::Cracked cracked = test::crack(mesh, recipe, seed);
    StatisticsOptions options;
    options.bootstrap.resamples = 0;
    const Simulation& s = cracked.simulation;
    const Statistics statistics =
        compute_statistics(graph_from_network(crack_network(s), s.mesh()), options);
    mean.spacing += statistics.root_area.value / seeds;
    mean.t_share += statistics.t_fraction.value / seeds;
    mean.angle += statistics.leg_angle.value / seeds;
    mean.anisotropy += statistics.anisotropy.value / seeds;
    mean.null += statistics.anisotropy_null.value / seeds;
  }
  return mean;
}

void expect_alike(const Pattern& a, const Pattern& b) {
  EXPECT_NEAR(a.spacing / b.spacing, 1, 0.1);
  EXPECT_NEAR(a.t_share, b.t_share, 0.08);
  EXPECT_NEAR(a.angle, b.angle, 6);
}

/// A closed tube of quads, cut along one diagonal, as a lathe makes it: `around` columns, `along`
/// rows, flat ends of slivers.
SurfaceMesh lathe(int around, int along) {
  SurfaceMesh mesh;
  const auto at = [&](int i, int j) { return j * around + i % around; };
  for (int j = 0; j <= along; ++j) {
    for (int i = 0; i < around; ++i) {
      const double a = 2 * pi * i / around, z = 1.5 * j / along;
      const double r = 0.4 + 0.2 * std::sin(2.5 * z);
      mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
  }
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < around; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  for (int i = 1; i + 1 < around; ++i) {
    mesh.triangles.push_back({at(0, 0), at(i + 1, 0), at(i, 0)});
    mesh.triangles.push_back({at(0, along), at(i, along), at(i + 1, along)});
  }
  return mesh;
}

TEST(SimulationMesh, ACubeOfTwelveTrianglesCracksLikeAFineOne) {
  const EdgeLength automatic, fine{EdgeLength::Kind::given, 0.03};
  expect_alike(pattern_of(make_shape("cube?n=1"), automatic),
               pattern_of(make_shape("cube?n=24"), fine));
}

TEST(SimulationMesh, ALathesQuadGridCracksLikeEvenTriangles) {
  const EdgeLength fine{EdgeLength::Kind::given, 0.03};
  const Pattern grid = pattern_of(lathe(36, 12), {});
  expect_alike(grid, pattern_of(lathe(72, 48), fine));
  EXPECT_LT(grid.anisotropy, 4 * grid.null) << "no rows or diagonals";
}

TEST(SimulationMesh, ALowPolyAssetKeepsItsTextureAndMaterials) {
  for (const std::string shape : {"cube?n=1", "cup?n=24", "torus?n=24"}) {
    SurfaceMesh asset = make_shape(shape);
    asset.material_names = {"paint", "bare"};
    for (std::size_t f = 0; f < asset.triangles.size(); ++f) {
      asset.face_materials.push_back(asset.positions[asset.triangles[f][0]].z() > 0 ? 0 : 1);
    }
    RepairReport report;
    asset = repair(asset, {}, report);
    Recipe recipe = read_preset("glaze");
    recipe.simulation.layer.relative_spacing = 0.12;
    const Result result =
        crack({std::make_shared<const SurfaceMesh>(asset), {}, shape}, recipe, {}, {});
    ASSERT_GT(result.report().simulation.triangles, 5 * result.report().input.triangles) << shape;
    const SurfaceMesh output = cut_surface(result, growth_times(result), {});

    const test::TextureShift shift = test::texture_shift(asset, output);
    // At a pole of the texture, where all columns meet, a triangle's own UVs are of no use.
    EXPECT_LT(shift.displaced, 0.01) << shape;
    EXPECT_LT(shift.mean, 1e-3) << shape;
    ASSERT_EQ(output.face_materials.size(), output.triangles.size()) << shape;
    EXPECT_EQ(output.material_names, asset.material_names) << shape;
    for (std::size_t f = 0; f < output.triangles.size(); ++f) {
      EXPECT_EQ(output.face_materials[f], asset.face_materials[output.source_faces[f]]) << shape;
    }
  }
}

}  // namespace
}  // namespace craze
