#include "craze/io/polygons/unify_corners.h"

#include "io/io_test_tools.h"

namespace craze {
namespace {

TEST(UnifyCorners, CopiesVerticesOnlyWhereCornersDiffer) {
  SurfaceMesh mesh = rich_mesh(4);
  mesh.corner_normals.clear();
  const UnifiedCorners unified = unify_corners(mesh);
  // The seam runs across the strip's two middle vertices.
  EXPECT_EQ(unified.sources.size(), mesh.positions.size() + 2);
  EXPECT_EQ(unified.sources[mesh.positions.size()], 4);
  EXPECT_EQ(unified.sources[mesh.positions.size() + 1], 5);
}

TEST(UnifyCorners, EachCornerKeepsItsValuesAndItsVertex) {
  const SurfaceMesh mesh = rich_mesh(6);
  const UnifiedCorners unified = unify_corners(mesh);
  for (std::size_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
    const std::int32_t v = unified.triangles[c / 3][c % 3];
    EXPECT_EQ(unified.sources[v], mesh.triangles[c / 3][c % 3]);
    EXPECT_EQ(unified.uvs[v], mesh.corner_uvs[c]);
    EXPECT_EQ(unified.normals[v], mesh.corner_normals[c]);
  }
}

TEST(UnifyCorners, VerticesKeepTheirNumbers) {
  const SurfaceMesh mesh = rich_mesh(6);
  const UnifiedCorners unified = unify_corners(mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(unified.sources[v], static_cast<std::int32_t>(v));
  }
}

TEST(UnifyCorners, VerticesWithoutFacesKeepTheirPlace) {
  SurfaceMesh mesh = rich_mesh(2);
  mesh.positions.emplace_back(9, 9, 9);
  EXPECT_EQ(unify_corners(mesh).sources[6], 6);
}

TEST(UnifyCorners, AVertexOfManyDifferentCornersIsNoTrap) {
  SurfaceMesh mesh;  // a fan whose hub has another UV in each face
  mesh.positions.emplace_back(0, 0, 0);
  const std::int32_t n = 200'000;
  for (std::int32_t i = 1; i <= n; ++i) mesh.positions.emplace_back(i, 1, 0);
  for (std::int32_t i = 1; i < n; ++i) {
    mesh.triangles.push_back({0, i, i + 1});
    mesh.corner_uvs.insert(mesh.corner_uvs.end(), {Vec2(i, 0), Vec2(0, 0), Vec2(0, 0)});
  }
  EXPECT_EQ(unify_corners(mesh).sources.size(), mesh.positions.size() + n - 2);
}

}  // namespace
}  // namespace craze
