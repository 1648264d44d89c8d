#include "craze/repair.h"

#include <gtest/gtest.h>

#include <string>

#include "craze/shapes.h"
#include "mesh/repair/repaired.h"

namespace craze {
namespace {

using test::append;
using test::bare;
using test::exploded;
using test::repaired;
using test::Repaired;

SurfaceMesh two_sided(SurfaceMesh s) {
  for (std::size_t f = 0, n = s.triangles.size(); f < n; ++f) {
    const Triangle t = s.triangles[f];
    s.triangles.push_back({t[0], t[2], t[1]});
  }
  return s;
}

TEST(Repair, ASheetOfTwoSidesBecomesOneLayer) {
  const Repaired r = repaired(two_sided(bare(make_shape("plate?n=4"))));
  EXPECT_EQ(r.report.duplicate_faces, 32);
  EXPECT_NEAR(r.summary.area, 1, 1e-12);
  EXPECT_EQ(r.summary.components, 1);
  EXPECT_EQ(r.report.flipped_faces, 0);
}

TEST(Repair, AFinOfTwoSidesGoesAndTheSolidStaysClosed) {
  SurfaceMesh s = bare(make_shape("cube?n=2"));
  const auto faces = static_cast<std::int32_t>(s.triangles.size());
  const Triangle t = s.triangles[0];
  s.positions.emplace_back(0, 0, 3);
  const auto tip = static_cast<std::int32_t>(s.positions.size() - 1);
  s.triangles.push_back({t[0], t[1], tip});
  s.triangles.push_back({t[1], t[0], tip});
  const Repaired r = repaired(s);
  EXPECT_EQ(r.summary.faces, faces);
  EXPECT_TRUE(r.summary.closed());
  EXPECT_EQ(r.report.cut_edges, 0);
}

TEST(Repair, ALidOfTwoSidesStays) {
  SurfaceMesh s = bare(make_shape("cube?n=1"));
  const Triangle t = s.triangles[0];
  s.triangles.push_back({t[1], t[0], t[2]});
  const Repaired r = repaired(s);
  EXPECT_TRUE(r.summary.closed());
  EXPECT_EQ(r.report.duplicate_faces, 1);
}

/// Cubes of side 1 in a row along x, each with vertices of its own; the walls they share coincide.
SurfaceMesh row_of_cubes(int count, int n) {
  SurfaceMesh s;
  const SurfaceMesh cube = bare(make_shape("cube?n=" + std::to_string(n)));
  Vec3 low = cube.positions[0], high = low;
  for (const Vec3& p : cube.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double side = (high - low).x();
  for (int i = 0; i < count; ++i) {
    SurfaceMesh next = cube;
    if (i % 2 == 1) {  // mirrored, so that the triangles of the shared walls are the same
      for (Vec3& p : next.positions) p.x() = low.x() + high.x() - p.x();
      for (Triangle& t : next.triangles) std::swap(t[1], t[2]);
    }
    append(s, next, Vec3(-low.x() + i * side, 0, 0), 1);
  }
  for (Vec3& p : s.positions) p /= side;
  return s;
}

TEST(Repair, SolidsThatShareAWallKeepEachItsOwn) {
  for (const int count : {2, 3}) {
    for (const int n : {1, 3}) {
      const SurfaceMesh s = row_of_cubes(count, n);
      for (const SurfaceMesh& input : {s, exploded(s)}) {
        const Repaired r = repaired(input);
        EXPECT_EQ(r.report.duplicate_faces, 0);
        EXPECT_EQ(r.report.flipped_faces, 0);
        EXPECT_EQ(r.report.components, count);
        EXPECT_TRUE(r.summary.closed());
        EXPECT_NEAR(r.summary.area, 6 * count, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace craze
