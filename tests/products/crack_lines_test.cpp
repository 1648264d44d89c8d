#include <gtest/gtest.h>

#include <map>

#include "craze/presets.h"
#include "craze/products.h"
#include "craze/recipe.h"
#include "craze/shapes.h"

namespace craze {
namespace {

Result mud(const SurfaceMesh& surface, const std::string& setting = "mesh.edge=\"keep\"") {
  Recipe recipe = read_preset("mud");
  apply_set(recipe, setting);
  return crack({std::make_shared<SurfaceMesh>(surface), {}, "plate"}, recipe, {}, {});
}

/// The plate with UVs that follow its places.
SurfaceMesh with_plain_uvs(SurfaceMesh plate) {
  for (std::size_t c = 0; c < plate.corner_uvs.size(); ++c) {
    const Vec3& p = plate.positions[plate.triangles[c / 3][c % 3]];
    plate.corner_uvs[c] = Vec2(2 * p.x() + 1, p.y() - 3);
  }
  return plate;
}

void expect_plain_uvs(const LineSet& lines) {
  ASSERT_GT(lines.uvs.size(), 100u);
  for (std::size_t i = 0; i < lines.uvs.size(); ++i) {
    const Vec3& p = lines.points[lines.edges[i / 2][i % 2]];
    EXPECT_LT((lines.uvs[i] - Vec2(2 * p.x() + 1, p.y() - 3)).norm(), 1e-12);
  }
}

/// The greatest distance between two UVs that edges of one island have at one point.
double widest_gap(const LineSet& lines) {
  const Attribute& island = *find_attribute(lines.edge_attributes, "uv_island");
  std::map<std::pair<std::int32_t, double>, Vec2> known;
  double widest = 0;
  for (std::size_t e = 0; e < lines.edges.size(); ++e) {
    for (std::size_t end = 0; end < 2; ++end) {
      const Vec2& uv = lines.uvs[2 * e + end];
      const auto [at, fresh] = known.insert({{lines.edges[e][end], island.values[e]}, uv});
      widest = std::max(widest, (at->second - uv).norm());
    }
  }
  return widest;
}

TEST(CrackLines, JoinedEdgesMeetInTheTextureThoughVerticesHaveSlid) {
  const Result result = mud(make_shape("plate?n=30&jitter=0.3"));
  const LineSet lines = crack_lines(result);
  ASSERT_GT(lines.edges.size(), 100u);
  EXPECT_LT(widest_gap(lines), 1e-12);
}

TEST(CrackLines, UvsAreThoseOfThePlace) {
  expect_plain_uvs(crack_lines(mud(with_plain_uvs(make_shape("plate?n=30&jitter=0.3")))));
}

TEST(CrackLines, UvsAreThoseOfThePlaceOnAnAssetsOwnTriangles) {
  const SurfaceMesh plate = with_plain_uvs(make_shape("plate?n=2"));
  expect_plain_uvs(crack_lines(mud(plate, "mesh.output=\"asset\"")));
}

TEST(CrackLines, EachEdgeKnowsItsIsland) {
  SurfaceMesh plate = make_shape("plate?n=30");
  // Two halves, the right one beside the left one in the texture; a third of it without UVs.
  double low = 1e9, high = -1e9;
  for (const Vec3& p : plate.positions) {
    low = std::min(low, p.x());
    high = std::max(high, p.x());
  }
  const auto middle = [&](std::size_t f) {
    double x = 0;
    for (const std::int32_t v : plate.triangles[f]) x += plate.positions[v].x() / 3;
    return (x - low) / (high - low);
  };
  for (std::size_t f = 0; f < plate.triangles.size(); ++f) {
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
      if (middle(f) > 1 / 3.0) plate.corner_uvs[c].x() += 2;
      if (middle(f) > 2 / 3.0) plate.corner_uvs[c] = Vec2(0, 0);
    }
  }
  const LineSet lines = crack_lines(mud(plate));
  const Attribute* island = find_attribute(lines.edge_attributes, "uv_island");
  ASSERT_TRUE(island);
  std::map<int, int> count;
  for (std::size_t e = 0; e < lines.edges.size(); ++e) {
    const auto i = static_cast<int>(island->values[e]);
    ++count[i];
    const Vec2& uv = lines.uvs[2 * e];
    EXPECT_TRUE(i < 0 ? uv == Vec2(0, 0) : i == (uv.x() >= 2 ? 1 : 0)) << i << " at " << uv.x();
  }
  EXPECT_EQ(count.size(), 3u);
  EXPECT_LT(widest_gap(lines), 1e-12);
}

TEST(CrackLines, WithoutUvsThereAreNoIslands) {
  SurfaceMesh plate = make_shape("plate?n=20");
  plate.corner_uvs.clear();
  const LineSet lines = crack_lines(mud(plate));
  EXPECT_TRUE(lines.uvs.empty());
  EXPECT_FALSE(find_attribute(lines.edge_attributes, "uv_island"));
}

}  // namespace
}  // namespace craze
