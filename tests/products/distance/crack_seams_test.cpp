#include "craze/products/distance/crack_seams.h"

#include <gtest/gtest.h>

#include "craze/products/distance/seams.h"

namespace craze {
namespace {

/// A plate cut through in two places: at x = 1/3 and x = 2/3 the vertices are doubled.
struct TwiceParted {
  SurfaceMesh surface;
  static constexpr int side = 9;  // quads

  TwiceParted() {
    const int columns = side + 3;
    for (int y = 0; y <= side; ++y) {
      for (int x = 0; x < columns; ++x) {
        const int at = x - (x > side / 3 ? 1 : 0) - (x > 2 * side / 3 + 1 ? 1 : 0);
        surface.positions.emplace_back(at / double{side}, y / double{side}, 0);
      }
    }
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x + 1 < columns; ++x) {
        const int a = y * columns + x, b = a + 1, c = a + columns, d = c + 1;
        if (surface.positions[a] == surface.positions[b]) continue;
        surface.triangles.push_back({a, b, d});
        surface.triangles.push_back({a, d, c});
      }
    }
  }
  double middle(std::size_t f) const {
    double x = 0;
    for (const std::int32_t v : surface.triangles[f]) x += surface.positions[v].x() / 3;
    return x;
  }
  TriangleMesh mesh() const { return {surface.positions, surface.triangles}; }
  /// How many sides are taken for cracks near that x.
  int sides_near(double x) const {
    const TriangleMesh topology = mesh();
    int count = 0;
    for (const std::int32_t h : crack_seams(surface, topology)) {
      count += std::abs(topology.position(topology.from(h)).x() - x) < 0.01;
    }
    return count;
  }
};

TEST(CrackSeams, WhereTheSidesLookTheSameThereIsACrack) {
  const TwiceParted plate;
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 2 * TwiceParted::side);
}

TEST(CrackSeams, WhereUvsDifferThereIsNone) {
  TwiceParted plate;
  for (std::size_t f = 0; f < plate.surface.triangles.size(); ++f) {
    for (const std::int32_t v : plate.surface.triangles[f]) {
      const Vec3& p = plate.surface.positions[v];
      plate.surface.corner_uvs.emplace_back(p.x() + (plate.middle(f) > 2 / 3.0 ? 1 : 0), p.y());
    }
  }
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 0);
}

TEST(CrackSeams, WhereNormalsOrMaterialsDifferThereIsNone) {
  TwiceParted plate;
  for (std::size_t f = 0; f < plate.surface.triangles.size(); ++f) {
    const Vec3 normal = plate.middle(f) > 2 / 3.0 ? Vec3(0, 0.6, 0.8) : Vec3(0, 0, 1);
    plate.surface.corner_normals.insert(plate.surface.corner_normals.end(), 3, normal);
  }
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 0);

  TwiceParted painted;
  painted.surface.material_names = {"left", "right"};
  for (std::size_t f = 0; f < painted.surface.triangles.size(); ++f) {
    painted.surface.face_materials.push_back(painted.middle(f) > 1 / 3.0 ? 1 : 0);
  }
  EXPECT_EQ(painted.sides_near(1 / 3.0), 0);
  EXPECT_EQ(painted.sides_near(2 / 3.0), 2 * TwiceParted::side);
}

TEST(CrackSeams, AFileThatRepeatsEveryVertexHasNone) {
  const TwiceParted plate;
  SurfaceMesh soup;
  for (const Triangle& t : plate.surface.triangles) {
    const auto first = static_cast<std::int32_t>(soup.positions.size());
    for (const std::int32_t v : t) soup.positions.push_back(plate.surface.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const TriangleMesh topology(soup.positions, soup.triangles);
  EXPECT_FALSE(seam_sides(topology).empty());
  EXPECT_TRUE(crack_seams(soup, topology).empty());
}

TEST(CrackSeams, TheDistanceToTheCracksDecidesWhereItIsGiven) {
  TwiceParted plate;
  Attribute distance{"crack_distance", 1, {}};
  for (const Vec3& p : plate.surface.positions) {
    distance.values.push_back(std::abs(p.x() - TwiceParted::side / 3 / double{TwiceParted::side}));
  }
  plate.surface.vertex_attributes = {distance};
  EXPECT_EQ(plate.sides_near(1 / 3.0), 2 * TwiceParted::side);
  EXPECT_EQ(plate.sides_near(2 / 3.0), 0);
}

}  // namespace
}  // namespace craze
