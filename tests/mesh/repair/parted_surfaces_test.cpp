#include "craze/repair.h"

#include <gtest/gtest.h>

#include "craze/shapes.h"
#include "mesh/repair/repaired.h"

namespace craze {
namespace {

using test::append;
using test::bare;
using test::repaired;
using test::Repaired;

TEST(Repair, TwoSolidsThatShareAnEdgeAreParted) {
  SurfaceMesh s = bare(make_shape("cube?n=1"));
  append(s, bare(make_shape("cube?n=1")), Vec3(1, 1, 0));
  const Repaired r = repaired(s);
  EXPECT_EQ(r.report.nonmanifold_edges, 1);
  EXPECT_TRUE(r.summary.closed());
  EXPECT_NEAR(r.summary.volume, 2, 1e-12);
  EXPECT_EQ(r.report.cut_edges, 0);
}

TEST(Repair, AFinIsCutOffTheSurfaceThatGoesOnFlat) {
  SurfaceMesh s;  // two triangles in a plane and a third standing on their common edge
  s.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}};
  s.triangles = {{0, 1, 4}, {0, 1, 2}, {1, 0, 3}};
  const Repaired r = repaired(s);
  EXPECT_EQ(r.report.nonmanifold_edges, 1);
  EXPECT_EQ(r.report.cut_edges, 1);
  EXPECT_EQ(r.summary.components, 2);
  EXPECT_EQ(r.report.split_vertices, 2);
  const TriangleMesh mesh(r.surface.positions, r.surface.triangles);
  EXPECT_GE(mesh.opposite(3), 0);  // the flat pair stays joined
  EXPECT_TRUE(mesh.is_open(0));
}

TEST(Repair, FansThatTouchInAVertexArePartedWithTheirAttributes) {
  SurfaceMesh s;
  s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  s.triangles = {{0, 1, 2}, {0, 3, 4}};
  s.vertex_colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 0, 1}, {0, 1, 1, 1}};
  s.vertex_attributes = {{"pair", 2, {0, 10, 1, 11, 2, 12, 3, 13, 4, 14}}};
  const Repaired r = repaired(s);
  EXPECT_EQ(r.report.split_vertices, 1);
  ASSERT_EQ(r.surface.positions.size(), 6u);
  EXPECT_EQ(r.surface.vertex_colors[5], s.vertex_colors[0]);
  EXPECT_EQ(r.surface.vertex_attributes[0].values[11], 10);
  EXPECT_EQ(r.surface.triangles[1][0], 5);
}

TEST(Repair, SheetsJoinedAtBothEndsOfASharedEdgeGetAVertexOnIt) {
  // A closed surface pinched so that two of its edges lie on each other: both fans stay whole.
  SurfaceMesh s = bare(make_shape("torus?n=12&minor=0.6"));
  const TriangleMesh mesh(s.positions, s.triangles);
  const std::int32_t h = 0, a = mesh.from(h), b = mesh.to(h);
  // An edge whose ends are far from a and b, and from each other's neighbours.
  std::vector<char> near(s.positions.size(), 0);
  for (int ring = 0; ring < 3; ++ring) {
    std::vector<char> grown = near;
    grown[a] = grown[b] = 1;
    for (const Triangle& t : s.triangles) {
      if (near[t[0]] || near[t[1]] || near[t[2]]) grown[t[0]] = grown[t[1]] = grown[t[2]] = 1;
    }
    near = grown;
  }
  std::int32_t g = 0;
  while (near[mesh.from(g)] || near[mesh.to(g)]) ++g;
  const std::int32_t c = mesh.from(g), d = mesh.to(g);
  s.positions[c] = s.positions[b];
  s.positions[d] = s.positions[a];
  s.vertex_attributes = {{"x", 1, {}}};
  for (const Vec3& p : s.positions) s.vertex_attributes[0].values.push_back(p.x());
  const Repaired r = repaired(s);
  EXPECT_EQ(r.report.nonmanifold_edges, 1);
  EXPECT_TRUE(r.summary.closed());
  EXPECT_EQ(r.report.cut_edges, 0);
  for (std::size_t v = 0; v < r.surface.positions.size(); ++v) {
    EXPECT_NEAR(r.surface.vertex_attributes[0].values[v], r.surface.positions[v].x(), 1e-12);
  }
}

}  // namespace
}  // namespace craze
