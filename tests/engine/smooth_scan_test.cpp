// A scan without its bumps: the surface from which the simulation's mesh is made.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "craze/engine/simulation_surface.h"
#include "craze/recipe.h"

namespace craze {
namespace {

constexpr int cells = 60;

/// A unit square of a grid that is 20 times finer on one side than on the other, bumps of `height`.
SurfaceMesh uneven_square(double height) {
  SurfaceMesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const double t = static_cast<double>(i) / cells, x = 0.1 * t + 0.9 * t * t;
      const double up = (i + j) % 2 == 0 ? height : -height;
      mesh.positions.emplace_back(x, static_cast<double>(j) / cells, up);
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const std::int32_t a = j * (cells + 1) + i, b = a + 1, d = a + cells + 1, c = d + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

SimulationSurface scanned(const SurfaceMesh& mesh, double screening_length) {
  Recipe recipe;
  recipe.simulation.layer.screening_length = screening_length;
  return simulation_surface(mesh, recipe, {});
}

TEST(AScanWithoutItsBumps, HasItsVerticesWhereTheyWereAlongTheSurface) {
  const SurfaceMesh flat = uneven_square(0);
  constexpr double screening_length = 0.4, edge = screening_length / 4;
  const SimulationSurface surface = scanned(flat, screening_length);
  ASSERT_EQ(surface.smooth.size(), flat.positions.size());
  double furthest = 0;
  for (std::size_t v = 0; v < flat.positions.size(); ++v) {
    furthest = std::max(furthest, (surface.smooth[v] - flat.positions[v]).norm());
  }
  EXPECT_LE(furthest, 0.01 * edge);
}

TEST(AScanWithoutItsBumps, IsFlatWhereTheyWereFinerThanTheMesh) {
  constexpr double height = 0.01;
  const SimulationSurface surface = scanned(uneven_square(height), 0.4);
  ASSERT_FALSE(surface.smooth.empty());
  for (int j = 8; j <= cells - 8; ++j) {  // borders stay
    for (int i = 8; i <= cells - 8; ++i) {
      EXPECT_LE(std::abs(surface.smooth[j * (cells + 1) + i].z()), 0.01 * height);
    }
  }
}

}  // namespace
}  // namespace craze
