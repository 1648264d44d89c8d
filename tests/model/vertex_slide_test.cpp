#include "craze/model/cutting/vertex_slide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "craze/mesh/transfer_attributes.h"
#include "craze/mesh/validate.h"
#include "craze/model/cutting/crack_insertion.h"
#include "model/runs.h"
#include "model/states.h"

namespace craze {
namespace {

/// Slides every vertex that lets itself be slid once, by a random part of a random edge; returns
/// how many did.
int slide_many(CrackedSheet& sheet, std::uint64_t seed) {
  const TriangleMesh& mesh = sheet.mesh();
  Random random(seed);
  int slid = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.first_halfedge(v) < 0) continue;
    if (slide_vertex(sheet, mesh.first_halfedge(v), random.uniform(0.05, 0.4))) ++slid;
  }
  return slid;
}

TEST(VertexSlide, InThePlaneTheSurfaceStaysAsItIs) {
  CrackedSheet sheet =
      test::sheet_of(test::mesh_of("plate?n=12&jitter=0.3"), Sym3{1, 2, 0, 0.5, 0, 0});
  const TriangleMesh& mesh = sheet.mesh();
  const double area = mesh.total_area();
  EXPECT_GT(slide_many(sheet, 3), 40);
  EXPECT_TRUE(validate(mesh).empty());
  EXPECT_NEAR(mesh.total_area(), area, 1e-12 * area);
}

TEST(VertexSlide, LinearDisplacementsStrainTheSurfaceAsBefore) {
  CrackedSheet sheet =
      test::sheet_of(test::mesh_of("plate?n=12&jitter=0.3"), Sym3{1, 2, 0, 0.5, 0, 0});
  const TriangleMesh& mesh = sheet.mesh();
  StressField& field = sheet.field();
  // u = (0.3 x + 0.1 y, 0.2 y): the same strain everywhere, so forces on borders alone.
  const auto linear = [](const Vec3& p) { return Vec3(0.3 * p.x() + 0.1 * p.y(), 0.2 * p.y(), 0); };
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3 u = linear(mesh.position(v));
    field.displacements()[v].v = Vec4d::Lanes{u.x(), u.y(), u.z(), 0};
  }
  test::displace_all(mesh, field, field.displacements());
  const Sym3 expected{1.3, 2.2, 0, 0.55, 0, 0};
  EXPECT_GT(slide_many(sheet, 4), 40);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_LT(test::distance(field.stress(mesh, f), expected), 1e-12);
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_LT((field.displacement(v) - linear(mesh.position(v))).norm(), 1e-12);
    if (mesh.is_open_vertex(v)) continue;
    EXPECT_LT(field.force(v).norm(), 1e-12);
  }
}

TEST(VertexSlide, BordersPinnedVerticesAndFoldsStayWhereTheyAre) {
  TriangleMesh plate = test::mesh_of("plate?n=6");
  for (std::int32_t v = 0; v < plate.vertex_count(); ++v) {
    if (!plate.is_open_vertex(v)) plate.pin(v);
  }
  CrackedSheet on_plate = test::sheet_of(plate, Sym3{1, 1, 0, 0, 0, 0});
  for (std::int32_t v = 0; v < plate.vertex_count(); ++v) {
    EXPECT_FALSE(slide_vertex(on_plate, plate.first_halfedge(v), 0.2));
  }
  CrackedSheet on_cube = test::sheet_of(test::mesh_of("cube?n=4"), Sym3{});
  const TriangleMesh& cube = on_cube.mesh();
  const std::vector<Vec3> before = cube.positions();
  int slid = 0;
  for (std::int32_t h = 0; h < 3 * cube.face_count(); ++h) {
    if (slide_vertex(on_cube, h, 0.1)) ++slid;
  }
  EXPECT_GT(slid, 0);
  // Nothing left the sides of the cube.
  const double side = before.front().cwiseAbs().maxCoeff();
  for (const Vec3& p : cube.positions()) EXPECT_NEAR(p.cwiseAbs().maxCoeff(), side, 1e-12);
}

TEST(VertexSlide, ACrackRunsStraightPastAVertexThatGivesWay) {
  constexpr double degree = std::numbers::pi / 180;
  for (const double angle : {2.0, 9.0, 17.0, 31.0, 43.0}) {
    CrackedSheet sheet = test::sheet_of(test::mesh_of("plate?n=8"), Sym3{1, 1, 0, 0, 0, 0});
    const TriangleMesh& mesh = sheet.mesh();
    std::int32_t middle = 0;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.position(v).norm() < mesh.position(middle).norm()) middle = v;
    }
    const std::int32_t faces = mesh.face_count();
    const double area = mesh.total_area();
    const Vec3 along(std::cos(angle * degree), std::sin(angle * degree), 0);
    CrackOutcome outcome;
    open_crack(sheet, middle, {-along.y(), along.x(), 0},
               {25 * degree, 15 * degree, NearVertex::slide}, 0, outcome);
    ASSERT_EQ(outcome.segments.size(), 2u) << angle;
    for (const CrackSegment& s : outcome.segments) {
      const Vec3 way = mesh.position(s.to_root) - mesh.position(s.from_root);
      EXPECT_LT(way.cross(along).norm(), 1e-12 * way.norm()) << angle;
    }
    EXPECT_EQ(mesh.face_count(), faces) << angle;
    EXPECT_NEAR(mesh.total_area(), area, 1e-12 * area);
    EXPECT_TRUE(validate(mesh).empty());
  }
}

TEST(VertexSlide, AttributesStayWhereTheyWere) {
  const SurfaceMesh plate = make_shape("plate?n=30&jitter=0.3");
  ASSERT_FALSE(plate.corner_uvs.empty());
  SimulationParameters p = test::layer_run();
  p.crack = {25, 15, NearVertex::slide};
  Simulation s = test::simulation_of("plate?n=30&jitter=0.3", p);
  s.run({});
  const SurfaceMesh made = transfer_attributes(plate, s.mesh());
  int slid = 0;
  for (std::size_t k = 0; k < made.corner_uvs.size(); ++k) {
    const std::int32_t v = made.triangles[k / 3][k % 3];
    if (s.mesh().anchor(v) >= 0) ++slid;
    // The shape's UVs are its x and y, scaled and shifted.
    const Vec2 expected =
        (made.positions[v].head<2>() - plate.positions[0].head<2>())
            .cwiseQuotient(plate.positions.back().head<2>() - plate.positions[0].head<2>());
    EXPECT_LT((made.corner_uvs[k] - expected).norm(), 1e-9);
  }
  EXPECT_GT(slid, 300);
}

}  // namespace
}  // namespace craze
