#include "craze/products/opening/opening.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "craze/error.h"
#include "craze/mesh/self_intersection.h"
#include "products/distance/surfaces.h"
#include "products/opening/real_runs.h"

namespace craze {
namespace {

/// A third of the edges cut in random order, with splits of one side or both in between.
void crack_thoroughly(TriangleMesh& mesh, std::uint64_t seed) {
  test::cut_at_random(mesh, mesh.face_count(), 0, seed);
  test::cut_at_random(mesh, 30, 3, seed + 1);
}

std::vector<Vec3> random_displacement(const TriangleMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> u(mesh.vertex_count());
  for (Vec3& d : u) d = Vec3(random.normal(), random.normal(), random.normal());
  return u;
}

/// Adjacency of the result; throws if it is not manifold or not oriented consistently.
TriangleMesh adjacency(const OpenedMesh& opened) {
  return {opened.mesh.positions, opened.mesh.triangles};
}

double volume(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
  }
  return sum;
}

constexpr OpeningOptions walls{.gap = 0.01, .wall = 0.05};

TEST(Opening, AClosedSurfaceStaysClosedHoweverItIsCracked) {
  EXPECT_TRUE(rc::check([] {
    TriangleMesh mesh = test::torus(12);
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    crack_thoroughly(mesh, seed);
    const TriangleMesh result =
        adjacency(open_cracks(mesh, random_displacement(mesh, seed), walls, {}));
    for (std::int32_t h = 0; h < 3 * result.face_count(); ++h) RC_ASSERT(!result.is_open(h));
  }));
}

TEST(Opening, ABorderedSurfaceIsOpenAtItsBorderOnly) {
  EXPECT_TRUE(rc::check([] {
    TriangleMesh mesh = test::plate(8, 0.3);
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    crack_thoroughly(mesh, seed);
    OpeningOptions options = walls;
    options.border_wall = *rc::gen::arbitrary<bool>();
    const OpenedMesh opened = open_cracks(mesh, random_displacement(mesh, seed), options, {});
    const TriangleMesh result = adjacency(opened);
    const auto on_border = [&](std::int32_t v) {
      const Vec3& p = mesh.position(opened.vertex_of[v]);
      return std::min(std::min(p.x(), 1 - p.x()), std::min(p.y(), 1 - p.y())) < 1e-12;
    };
    for (std::int32_t h = 0; h < 3 * result.face_count(); ++h) {
      if (!result.is_open(h)) continue;
      RC_ASSERT(on_border(result.from(h)) && on_border(result.to(h)));
      // With walls there, the border has moved to the bottom.
      RC_ASSERT(!options.border_wall ||
                std::min(result.from(h), result.to(h)) >= mesh.vertex_count());
    }
  }));
}

TEST(Opening, WallsFaceTheGapAndReachDownToTheirDepth) {
  TriangleMesh mesh = test::plate(9, 0.3);
  crack_thoroughly(mesh, 4);
  // Every piece shrinks towards its own middle.
  std::vector<Vec3> u(mesh.vertex_count(), Vec3::Zero());
  std::vector<int> faces(mesh.vertex_count(), 0);
  for (const Triangle& t : mesh.triangles()) {
    const Vec3 middle = (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3;
    for (const std::int32_t v : t) {
      u[v] += middle - mesh.position(v);
      ++faces[v];
    }
  }
  for (std::size_t v = 0; v < u.size(); ++v) u[v] /= std::max(1, faces[v]);
  const OpenedMesh opened = open_cracks(mesh, u, {.gap = 0.02, .wall = 0.05}, {});
  EXPECT_EQ(opened.limited_vertices, 0);
  ASSERT_GT(opened.mesh.triangles.size(), mesh.triangles().size());
  for (std::size_t v = mesh.vertex_count(); v < opened.mesh.positions.size(); ++v) {
    EXPECT_TRUE(opened.mesh.positions[v].isApprox(
        mesh.position(opened.vertex_of[v]) - Vec3(0, 0, 0.05), 1e-12));
  }
  for (std::size_t f = 0; f < opened.face_of.size(); ++f) {
    EXPECT_EQ(opened.mesh.face_materials[f] == 0, opened.face_of[f] < 0);
    EXPECT_EQ(opened.face_of[f] < 0, f >= mesh.triangles().size());
  }
}

TEST(Opening, GroovesTakeAwayVolume) {
  const Simulation simulation = test::cracked("sphere?n=12");
  const TriangleMesh& mesh = simulation.mesh();
  SurfaceMesh shut;
  shut.positions = mesh.positions();
  shut.triangles = mesh.triangles();
  const std::vector<Vec3> u = test::displacements(simulation);
  double before = volume(shut);
  for (const double wall : {0.01, 0.02, 0.04}) {
    const OpenedMesh opened = open_cracks(mesh, u, {.gap = 0.1, .wall = wall}, {});
    EXPECT_EQ(opened.crossings, 0);
    EXPECT_LT(volume(opened.mesh), before) << "deeper grooves take more";
    before = volume(opened.mesh);
  }
}

TEST(Opening, MovesEveryVertexByGammaTimesItsVirtualDisplacement) {
  TriangleMesh mesh = test::plate(6, 0.2);
  crack_thoroughly(mesh, 2);
  std::vector<Vec3> u;
  for (const Vec3& p : mesh.positions()) u.emplace_back(0.3 * p.y(), 0.2 * p.x() - 0.1, p.x());
  const OpenedMesh opened = open_cracks(mesh, u, {.gap = 0.25}, {});
  EXPECT_EQ(opened.limited_vertices, 0);
  ASSERT_EQ(opened.mesh.positions.size(), u.size());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_TRUE(opened.mesh.positions[v].isApprox(mesh.position(v) + 0.25 * u[v], 1e-12));
  }
}

TEST(Opening, TheBorderMayBeKept) {
  const TriangleMesh mesh = test::plate(4, 0.2);
  const std::vector<Vec3> u(mesh.vertex_count(), Vec3(0.1, 0.2, 0));
  const OpenedMesh opened = open_cracks(mesh, u, {.gap = 1, .keep_border = true}, {});
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(opened.mesh.positions[v] == mesh.position(v), mesh.is_open_vertex(v));
  }
}

TEST(Opening, ACrackOfOneEdgeInsideTheSurfaceStaysShut) {
  TriangleMesh mesh = test::torus(8);
  mesh.cut(0, 0);
  const OpenedMesh opened = open_cracks(mesh, random_displacement(mesh, 1), walls, {});
  EXPECT_EQ(opened.mesh.triangles.size(), mesh.triangles().size());
  EXPECT_EQ(opened.mesh.positions.size(), mesh.positions().size());
}

TEST(Opening, GoesOnlySoFarThatNoFaceTurnsOver) {
  const TriangleMesh mesh = test::plate(5, 0);
  std::vector<Vec3> u(mesh.vertex_count(), Vec3::Zero());
  EXPECT_EQ(open_cracks(mesh, u, {.gap = 1}, {}).limited_vertices, 0);
  u[14] = Vec3(0.5, 0, 0);
  const OpenedMesh opened = open_cracks(mesh, u, {.gap = 1}, {});
  EXPECT_GT(opened.limited_vertices, 0);
  EXPECT_LT(opened.least_share, 0.4) << "it is a cell, 0.2, to the next vertex";
  EXPECT_GT(opened.least_share, 0.1);
  EXPECT_EQ(opened.folded_faces, 0);
  EXPECT_GT(opened.mesh.positions[14].x(), mesh.position(14).x());
  EXPECT_EQ(opened.mesh.positions[0], mesh.position(0));
}

TEST(Opening, WhatCrossesAsItIsIsNoReasonToOpenLess) {
  const TriangleMesh plate = test::plate(20, 0);
  std::vector<Vec3> folded = plate.positions();
  for (Vec3& p : folded) {
    p.z() = (p.x() - 0.4) * std::sin(20 * p.y());
    p.x() = std::abs(p.x() - 0.4);
  }
  std::vector<Vec3> twice = plate.positions();  // and one across it, a shell of its own
  std::vector<Triangle> both = plate.triangles();
  for (const Vec3& p : plate.positions()) twice.emplace_back(p.x() + 0.01, 0.43, p.y() - 0.47);
  for (const auto& [a, b, c] : plate.triangles()) {
    const std::int32_t n = plate.vertex_count();
    both.push_back({a + n, b + n, c + n});
  }
  for (TriangleMesh mesh : {TriangleMesh(folded, plate.triangles()), TriangleMesh(twice, both)}) {
    ASSERT_FALSE(self_intersections(mesh.positions(), mesh.triangles()).empty());
    test::cut_at_random(mesh, 200, 0, 3);
    const std::vector<Vec3> still(mesh.positions().size(), Vec3::Zero());
    const OpenedMesh opened = open_cracks(mesh, still, {.gap = 1}, {});
    EXPECT_EQ(opened.limited_vertices, 0);
    EXPECT_EQ(opened.crossings, 0);
  }
}

TEST(Opening, RefusesWhatMakesNoSense) {
  const TriangleMesh mesh = test::plate(2, 0);
  const std::vector<Vec3> u(mesh.vertex_count(), Vec3::Zero());
  EXPECT_THROW(open_cracks(mesh, {}, walls, {}), Error);
  EXPECT_THROW(open_cracks(mesh, u, {.gap = -1}, {}), Error);
  EXPECT_THROW(open_cracks(mesh, u, {.wall = std::numeric_limits<double>::infinity()}, {}), Error);
}

}  // namespace
}  // namespace craze
