#include "craze/repair.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "craze/base/random.h"
#include "craze/error.h"
#include "craze/mesh/repair/weld.h"
#include "craze/shapes.h"
#include "mesh/repair/repaired.h"

namespace craze {
namespace {

using test::bare;
using test::exploded;
using test::repaired;
using test::Repaired;

TEST(Repair, ASoundMeshComesBackAsItWas) {
  for (const ShapeInfo& info : shape_table()) {
    const SurfaceMesh s = make_shape(info.name);
    const Repaired r = repaired(s);
    EXPECT_FALSE(r.report.defects()) << info.name << ": " << r.report.text();
    EXPECT_EQ(r.report.text(), "") << info.name;
    EXPECT_EQ(r.surface.positions, s.positions);
    EXPECT_EQ(r.surface.triangles, s.triangles);
    EXPECT_EQ(r.surface.corner_uvs, s.corner_uvs);
    EXPECT_EQ(r.surface.corner_normals, s.corner_normals);
  }
}

TEST(Repair, WeldingJoinsSeamsAndKeepsBothSidesUvs) {
  const SurfaceMesh cup = make_shape("cup?n=40");
  SurfaceMesh s = exploded(cup);
  const Repaired r = repaired(s);
  EXPECT_TRUE(r.summary.closed());
  EXPECT_EQ(r.surface.positions.size(), cup.positions.size());
  EXPECT_EQ(r.report.merged_vertices,
            static_cast<std::int32_t>(s.positions.size() - cup.positions.size()));
  EXPECT_EQ(r.surface.corner_uvs, cup.corner_uvs);
  EXPECT_FALSE(r.report.defects());
  const Repaired apart = repaired(s, -1);
  EXPECT_EQ(apart.summary.components, apart.summary.faces);
}

TEST(Repair, WeldingReachesTheToleranceAndNoFarther) {
  const std::vector<Vec3> p{{0, 0, 0}, {0.9, 0, 0}, {1.8, 0, 0}, {-0.9, 0, 0}, {0, 0, 0}};
  // 0.9 joins 0; 1.8 does not follow it; −0.9 joins 0; the last equals 0.
  EXPECT_EQ(weld(p, 1.0), (std::vector<std::int32_t>{0, 0, 2, 0, 0}));
  EXPECT_EQ(weld(p, 0.0), (std::vector<std::int32_t>{0, 1, 2, 3, 0}));
}

RC_GTEST_PROP(Repair, WeldedVerticesAreNearAndTheRestIsApart, (std::uint64_t seed)) {
  Random random(seed);
  std::vector<Vec3> p(200);
  for (Vec3& x : p) x = Vec3(random.uniform(), random.uniform(), 0.1 * random.uniform());
  const double tolerance = random.uniform(0, 0.1);
  const auto first = weld(p, tolerance);
  for (std::size_t v = 0; v < p.size(); ++v) {
    RC_ASSERT(first[first[v]] == first[v]);
    RC_ASSERT((p[first[v]] - p[v]).norm() <= tolerance);
    for (std::size_t w = 0; w < v; ++w) {
      const bool both =
          first[v] == static_cast<std::int32_t>(v) && first[w] == static_cast<std::int32_t>(w);
      if (both) RC_ASSERT((p[v] - p[w]).norm() > tolerance);
    }
  }
}

TEST(Repair, DegenerateAndDuplicateFacesGo) {
  SurfaceMesh s = bare(make_shape("plate?n=2"));
  const auto faces = static_cast<std::int32_t>(s.triangles.size());
  s.triangles.push_back({0, 0, 1});       // repeated corner
  s.triangles.push_back({0, 1, 2});       // collinear
  s.triangles.push_back(s.triangles[3]);  // the same again
  const Triangle t = s.triangles[5];
  s.triangles.push_back({t[1], t[0], t[2]});  // and the other way round
  const Repaired r = repaired(s);
  EXPECT_EQ(r.report.degenerate_faces, 2);
  EXPECT_EQ(r.report.duplicate_faces, 2);
  EXPECT_EQ(r.summary.faces, faces);
  EXPECT_NEAR(r.summary.area, 1, 1e-12);
}

TEST(Repair, UnusedVerticesGo) {
  SurfaceMesh s = bare(make_shape("cube?n=2"));
  s.positions.insert(s.positions.begin(), Vec3(9, 9, 9));
  for (Triangle& t : s.triangles) {
    for (std::int32_t& v : t) ++v;
  }
  const Repaired r = repaired(s);
  EXPECT_EQ(r.report.unused_vertices, 1);
  EXPECT_NEAR(r.summary.volume, 1, 1e-12);
}

TEST(Repair, FaceAttributesAndSourcesFollowTheirFaces) {
  SurfaceMesh s = bare(make_shape("plate?n=3"));
  s.triangles[4] = {0, 0, 0};
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    s.face_materials.push_back(static_cast<std::int32_t>(f % 3));
    s.face_objects.push_back(static_cast<std::int32_t>(f % 2) - 1);
    s.source_faces.push_back(static_cast<std::int32_t>(100 + f));
  }
  s.object_names = {"o"};
  s.material_names = {"a", "b", "c"};
  s.face_attributes = {{"id", 1, std::vector<double>(s.triangles.size())}};
  std::iota(s.face_attributes[0].values.begin(), s.face_attributes[0].values.end(), 0);
  const Repaired r = repaired(s);
  ASSERT_EQ(r.surface.triangles.size(), s.triangles.size() - 1);
  for (std::size_t f = 0; f < r.surface.triangles.size(); ++f) {
    const std::size_t old = f < 4 ? f : f + 1;
    EXPECT_EQ(r.surface.source_faces[f], static_cast<std::int32_t>(100 + old));
    EXPECT_EQ(r.surface.face_materials[f], static_cast<std::int32_t>(old % 3));
    EXPECT_EQ(r.surface.face_objects[f], static_cast<std::int32_t>(old % 2) - 1);
    EXPECT_EQ(r.surface.face_attributes[0].values[f], static_cast<double>(old));
  }
  EXPECT_EQ(r.surface.material_names, s.material_names);
  EXPECT_EQ(r.surface.object_names, s.object_names);
}

TEST(Repair, WithoutSourcesEachTriangleNamesItself) {
  SurfaceMesh s = bare(make_shape("plate?n=1"));
  s.triangles.insert(s.triangles.begin(), {0, 0, 0});
  EXPECT_EQ(repaired(s).surface.source_faces, (std::vector<std::int32_t>{1, 2}));
}

TEST(Repair, BadInputIsRefusedWithItsPlace) {
  const auto message = [](const SurfaceMesh& s) -> std::string {
    RepairReport report;
    try {
      repair(s, {}, report);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      return e.what();
    }
    return "";
  };
  SurfaceMesh s = bare(make_shape("plate?n=1"));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e60}) {
    SurfaceMesh broken = s;
    broken.positions[2].y() = bad;
    EXPECT_NE(message(broken).find("vertex 2"), std::string::npos);
  }
  SurfaceMesh broken = s;
  broken.triangles[1][2] = 4;
  EXPECT_NE(message(broken).find("face 1"), std::string::npos);
  broken = s;
  broken.corner_uvs.resize(5);
  EXPECT_NE(message(broken).find("UVs"), std::string::npos);
  broken = s;
  broken.vertex_attributes = {{"heat", 2, {1}}};
  EXPECT_NE(message(broken).find("heat"), std::string::npos);
}

TEST(Repair, NothingSoundLeavesNothing) {
  SurfaceMesh s;
  EXPECT_TRUE(repaired(s).surface.triangles.empty());
  s.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  s.triangles = {{0, 1, 2}};
  EXPECT_TRUE(repaired(s).surface.triangles.empty());
}

// Few vertices and many faces: nearly every edge and vertex is non-manifold.
SurfaceMesh soup(std::uint64_t seed) {
  Random random(seed);
  SurfaceMesh s;
  const std::uint64_t vertices = 4 + random.below(12), faces = random.below(120);
  for (std::uint64_t v = 0; v < vertices; ++v) {
    s.positions.emplace_back(random.uniform(), random.uniform(), random.uniform());
  }
  for (std::uint64_t f = 0; f < faces; ++f) {
    Triangle t;
    for (std::int32_t& v : t) v = static_cast<std::int32_t>(random.below(vertices));
    std::sort(t.begin(), t.end());  // equal faces face alike: none of them is half of a sheet
    if (hash_bits(seed ^ (t[0] + 16 * t[1] + 256 * t[2])) % 2) std::swap(t[1], t[2]);
    s.triangles.push_back(t);
    for (int i = 0; i < 3; ++i) {
      const Vec3& p = s.positions[t[i]];
      s.corner_uvs.emplace_back(p.x() + 2 * p.y(), p.z());
    }
  }
  return s;
}

RC_GTEST_PROP(Repair, AnySoupBecomesManifold, (std::uint64_t seed)) {
  const SurfaceMesh s = soup(seed);
  const Repaired r = repaired(s);
  double area = 0;  // of the faces that had to stay
  std::vector<Triangle> seen;
  for (Triangle t : s.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    const Vec3 n =
        (s.positions[t[1]] - s.positions[t[0]]).cross(s.positions[t[2]] - s.positions[t[0]]);
    std::sort(t.begin(), t.end());
    if (std::find(seen.begin(), seen.end(), t) != seen.end()) continue;
    seen.push_back(t);
    area += n.norm() / 2;
  }
  RC_ASSERT(std::abs(r.summary.area - area) <= 1e-9 * (1 + area));
  for (std::size_t c = 0; c < r.surface.corner_uvs.size(); ++c) {  // linear in the position
    const Vec3& p = r.surface.positions[r.surface.triangles[c / 3][c % 3]];
    RC_ASSERT((r.surface.corner_uvs[c] - Vec2(p.x() + 2 * p.y(), p.z())).norm() < 1e-12);
  }
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(Repair, WhatWasRepairedNeedsNoSecondRepair, (std::uint64_t seed)) {
  const Repaired once = repaired(soup(seed), -1);
  const Repaired twice = repaired(once.surface, -1);
  RC_ASSERT(!twice.report.defects());
  RC_ASSERT(twice.surface.triangles == once.surface.triangles);
}

}  // namespace
}  // namespace craze
