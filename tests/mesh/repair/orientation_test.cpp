#include "craze/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "craze/base/random.h"
#include "craze/shapes.h"
#include "mesh/repair/repaired.h"

namespace craze {
namespace {

using test::append;
using test::bare;
using test::repaired;
using test::Repaired;

TEST(Repair, RandomlyFlippedFacesOfASolidComeOutOutward) {
  for (const bool mostly_inward : {false, true}) {
    SurfaceMesh s = make_shape("torus?n=30");
    const SurfaceMesh original = s;
    Random random(3);
    std::int32_t flipped = 0;
    for (std::size_t f = 0; f < s.triangles.size(); ++f) {
      if ((random.uniform() < 0.3) == mostly_inward) continue;
      ++flipped;
      std::swap(s.triangles[f][1], s.triangles[f][2]);
      std::swap(s.corner_uvs[3 * f + 1], s.corner_uvs[3 * f + 2]);
      std::swap(s.corner_normals[3 * f + 1], s.corner_normals[3 * f + 2]);
    }
    const Repaired r = repaired(s);
    EXPECT_EQ(r.report.flipped_faces, flipped);
    EXPECT_GT(r.summary.volume, 0);
    EXPECT_EQ(r.surface.triangles, original.triangles);
    EXPECT_EQ(r.surface.corner_uvs, original.corner_uvs);
    EXPECT_EQ(r.surface.corner_normals, original.corner_normals);
  }
}

TEST(Repair, NormalsOfAnInsideOutSolidAreTurnedWithIt) {
  SurfaceMesh s = make_shape("sphere?n=4");
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    std::swap(s.triangles[f][1], s.triangles[f][2]);
    std::swap(s.corner_normals[3 * f + 1], s.corner_normals[3 * f + 2]);
  }
  for (Vec3& n : s.corner_normals) n = -n;
  const Repaired r = repaired(s);
  EXPECT_GT(r.summary.volume, 0);
  for (std::size_t c = 0; c < r.surface.corner_normals.size(); ++c) {
    const Vec3& p = r.surface.positions[r.surface.triangles[c / 3][c % 3]];
    EXPECT_GT(r.surface.corner_normals[c].dot(p), 0.9);
  }
}

TEST(Repair, TheInnerWallOfAHollowSolidStaysInward) {
  SurfaceMesh s = bare(make_shape("sphere?n=4"));
  SurfaceMesh inner = bare(make_shape("sphere?n=3"));
  for (Triangle& t : inner.triangles) std::swap(t[1], t[2]);
  append(s, inner, Vec3::Zero(), 0.5);
  const Repaired r = repaired(s);
  EXPECT_EQ(r.report.flipped_faces, 0);
  EXPECT_EQ(r.report.components, 2);
}

TEST(Repair, AMoebiusStripIsCutOnceAcross) {
  SurfaceMesh s;
  const int n = 30;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * 3.141592653589793 * i / n;
    for (const double w : {-0.3, 0.3}) {
      const double r = 1 + w * std::cos(a / 2);
      s.positions.emplace_back(r * std::cos(a), r * std::sin(a), w * std::sin(a / 2));
    }
  }
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t a = 2 * i, b = 2 * i + 1;
    const std::int32_t c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    s.triangles.push_back({a, c, b});
    s.triangles.push_back({b, c, d});
  }
  const Repaired r = repaired(s);
  EXPECT_EQ(r.report.cut_edges, 1);
  EXPECT_EQ(r.report.split_vertices, 2);
  EXPECT_EQ(r.summary.faces, 2 * n);
  EXPECT_EQ(r.summary.euler_characteristic, 1);
  EXPECT_EQ(r.report.boundary_loops, 1);
}

}  // namespace
}  // namespace craze
