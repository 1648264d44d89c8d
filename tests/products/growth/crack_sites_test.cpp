#include "craze/products/growth/crack_sites.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "products/distance/surfaces.h"

namespace craze {
namespace {

/// Two triangles, cut apart along their diagonal from (1, 1) to (0, 0); halfedges 2 and 3.
TriangleMesh two_pieces() {
  TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  mesh.cut(2, 5);
  return mesh;
}

std::vector<Vec3> inner_positions(const TriangleMesh& mesh, const CrackSites& sites,
                                  std::int32_t h) {
  const auto i = std::find(sites.sides.begin(), sites.sides.end(), h) - sites.sides.begin();
  std::vector<Vec3> positions;
  for (std::int32_t k = sites.first[i]; k < sites.first[i + 1]; ++k) {
    positions.push_back(mesh.position(sites.vertex[sites.inner[k]]));
  }
  return positions;
}

TEST(CrackSites, CopiesOfAVertexShareASite) {
  const TriangleMesh mesh = two_pieces();
  const CrackSites sites = crack_sites(mesh);
  EXPECT_EQ(sites.vertex.size(), 2u);
  EXPECT_EQ(sites.site_of[mesh.from(2)], sites.site_of[mesh.to(3)]);
  EXPECT_EQ(sites.site_of[mesh.to(2)], sites.site_of[mesh.from(3)]);
  EXPECT_EQ(sites.site_of[1], -1);
  EXPECT_TRUE(sites.inner.empty());
}

TEST(CrackSites, AVertexThatSplitOneSideLiesInsideTheOther) {
  TriangleMesh mesh = two_pieces();
  mesh.split_edge(2, 0.25);  // from (1, 1)
  mesh.split_edge(2, 0.5);
  const CrackSites sites = crack_sites(mesh);
  EXPECT_EQ(sites.vertex.size(), 4u);
  const std::vector<Vec3> inner = inner_positions(mesh, sites, 3);  // from (0, 0)
  ASSERT_EQ(inner.size(), 2u);
  EXPECT_TRUE(inner[0].isApprox(Vec3(0.75, 0.75, 0)));
  EXPECT_TRUE(inner[1].isApprox(Vec3(0.875, 0.875, 0)));
}

TEST(CrackSites, SplitsOnBothSidesInterleaveOrMerge) {
  TriangleMesh mesh = two_pieces();
  const std::int32_t a = mesh.split_edge(2, 0.5).vertex;
  const std::int32_t b = mesh.split_edge(3, 0.5).vertex;
  CrackSites sites = crack_sites(mesh);
  EXPECT_EQ(sites.site_of[a], sites.site_of[b]);
  EXPECT_TRUE(sites.inner.empty());

  mesh.split_edge(3, 0.5);  // (0.25, 0.25) on this side only
  sites = crack_sites(mesh);
  EXPECT_EQ(sites.vertex.size(), 4u);
  ASSERT_EQ(sites.inner.size(), 1u);
  EXPECT_TRUE(mesh.position(sites.vertex[sites.inner[0]]).isApprox(Vec3(0.25, 0.25, 0)));
}

TEST(CrackSites, EveryPartOfASideHasItsPartOnTheOtherSide) {
  TriangleMesh mesh = test::torus(12);
  test::cut_at_random(mesh, mesh.face_count(), 1, 6);
  test::cut_at_random(mesh, 60, 3, 7);
  const CrackSites sites = crack_sites(mesh);
  EXPECT_FALSE(sites.inner.empty());
  std::vector<std::array<std::int32_t, 2>> there, back;
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    std::int32_t s = sites.site_of[mesh.from(sites.sides[i])];
    const auto go = [&](std::int32_t t) {
      there.push_back({s, t});
      back.push_back({t, s});
      s = t;
    };
    for (std::int32_t k = sites.first[i]; k < sites.first[i + 1]; ++k) go(sites.inner[k]);
    go(sites.site_of[mesh.to(sites.sides[i])]);
  }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  EXPECT_EQ(there, back);
}

}  // namespace
}  // namespace craze
