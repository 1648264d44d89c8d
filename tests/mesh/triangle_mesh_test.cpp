#include "craze/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include "craze/error.h"

namespace craze {
namespace {

TEST(TriangleMesh, SplitKeepsAreaAndAdjacency) {
  TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const auto split = mesh.split_edge(2, 0.25);  // edge 2 → 0, shared by both faces
  EXPECT_EQ(mesh.face_count(), 4);
  EXPECT_NEAR(mesh.total_area(), 1.0, 1e-15);
  EXPECT_TRUE(mesh.position(split.vertex).isApprox(Vec3(0.75, 0.75, 0)));
  int star = 0;
  mesh.for_each_outgoing(split.vertex, [&](std::int32_t h) {
    EXPECT_EQ(mesh.from(h), split.vertex);
    ++star;
  });
  EXPECT_EQ(star, 4);
}

TEST(TriangleMesh, ACutAcrossTheWholeMeshSeparatesBothEnds) {
  TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const auto cut = mesh.cut(2, 7);
  EXPECT_EQ(mesh.vertex_count(), 6);
  EXPECT_EQ(mesh.crack_of(2), 7);
  EXPECT_GE(cut.copy_of_from, 4);
  EXPECT_GE(cut.copy_of_to, 4);
  EXPECT_EQ(mesh.root(cut.copy_of_from), 2);
  EXPECT_EQ(mesh.root(cut.copy_of_to), 0);
}

TEST(TriangleMesh, RefusesWhatIsNotManifold) {
  const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  EXPECT_THROW(TriangleMesh(p, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), Error);
  EXPECT_THROW(TriangleMesh(p, {{0, 1, 2}, {0, 1, 3}}), Error);
  EXPECT_THROW(TriangleMesh(p, {{0, 1, 1}}), Error);
}

}  // namespace
}  // namespace craze
