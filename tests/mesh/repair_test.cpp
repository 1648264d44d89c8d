#include "craze/repair.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "craze/base/random.h"
#include "craze/error.h"
#include "craze/mesh/mesh_summary.h"
#include "craze/mesh/repair/weld.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/mesh/validate.h"
#include "craze/shapes.h"

namespace craze {
namespace {

struct Repaired {
  SurfaceMesh surface;
  RepairReport report;
  MeshSummary summary;
};

Repaired repaired(const SurfaceMesh& s, double tolerance = 1e-9) {
  Repaired r;
  r.surface = repair(s, {tolerance}, r.report);
  const TriangleMesh mesh(r.surface.positions, r.surface.triangles);
  const auto problems = validate(mesh);
  EXPECT_TRUE(problems.empty()) << problems.front();
  r.summary = summarize(mesh);
  EXPECT_EQ(r.summary.vertices, static_cast<std::int32_t>(r.surface.positions.size()));
  return r;
}

// Every triangle with corners of its own, as an STL file or a glTF with flat normals holds it.
SurfaceMesh exploded(const SurfaceMesh& s) {
  SurfaceMesh e = s;
  e.positions.clear();
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      e.positions.push_back(s.positions[s.triangles[f][i]]);
      e.triangles[f][i] = static_cast<std::int32_t>(3 * f + i);
    }
  }
  return e;
}

void append(SurfaceMesh& s, const SurfaceMesh& more, const Vec3& offset, double scale = 1) {
  const auto base = static_cast<std::int32_t>(s.positions.size());
  for (const Vec3& p : more.positions) s.positions.emplace_back(scale * p + offset);
  for (const Triangle& t : more.triangles) {
    s.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
}

SurfaceMesh bare(const SurfaceMesh& s) {
  SurfaceMesh b;
  b.positions = s.positions;
  b.triangles = s.triangles;
  return b;
}

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
