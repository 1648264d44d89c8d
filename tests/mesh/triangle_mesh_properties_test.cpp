// Thousands of random edits, and what must hold after each of them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "craze/base/random.h"
#include "craze/mesh/mesh_summary.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/mesh/validate.h"
#include "craze/shapes.h"

namespace craze {
namespace {

TriangleMesh triangle_mesh_of(const std::string& shape) {
  SurfaceMesh s = make_shape(shape);
  return {s.positions, s.triangles};
}

const std::vector<std::string>& shapes() {
  static const std::vector<std::string> names{
      "cube?n=1",           "cube?n=4",      "sphere?n=5",
      "torus?n=16",         "cylinder?n=12", "cylinder?n=12&open=1",
      "plate?n=1",          "plate?n=8",     "plate?n=8&jitter=0.4",
      "strip?n=1&length=9", "disc?n=12",     "cup?n=24"};
  return names;
}

std::int64_t edges_of(const TriangleMesh& mesh) {
  std::int64_t edges = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) edges += mesh.opposite(h) < h;
  return edges;
}

std::int64_t euler(const TriangleMesh& mesh) {
  return mesh.vertex_count() - edges_of(mesh) + mesh.face_count();
}

bool joins(const TriangleMesh& mesh, std::int32_t h, std::int32_t a, std::int32_t b) {
  return mesh.from(h) == a && mesh.to(h) == b;
}

// Splits h and checks what split_edge promises.
void split_and_check(TriangleMesh& mesh, std::int32_t h, double t) {
  const std::int32_t a = mesh.from(h), b = mesh.to(h), o = mesh.opposite(h);
  const std::int32_t faces = mesh.face_count();
  const std::int64_t chi = euler(mesh);
  const double whole = mesh.area(h / 3);
  const std::int32_t source = mesh.source_face(h / 3);
  const Vec3 expected = (1 - t) * mesh.position(a) + t * mesh.position(b);

  const TriangleMesh::Split s = mesh.split_edge(h, t);

  EXPECT_EQ(mesh.position(s.vertex), expected);
  EXPECT_EQ(mesh.root(s.vertex), s.vertex);
  EXPECT_TRUE(joins(mesh, h, a, s.vertex));
  EXPECT_EQ(mesh.face_count(), faces + (o < 0 ? 1 : 2));
  EXPECT_EQ(euler(mesh), chi);
  EXPECT_NEAR(mesh.area(s.face[0]) + mesh.area(s.new_face[0]), whole,
              1e-12 * whole + 1e-15);  // slivers: rounding of coordinates of order 1
  EXPECT_EQ(mesh.source_face(s.new_face[0]), source);
  std::int32_t rest = -1;  // the other half of the edge, x → b
  mesh.for_each_outgoing(s.vertex, [&](std::int32_t g) {
    if (mesh.to(g) == b) rest = g;
  });
  ASSERT_GE(rest, 0);
  if (o < 0) {
    EXPECT_EQ(s.face[1], -1);
    EXPECT_EQ(mesh.opposite(h), o);  // border or the crack's label, on both halves
    EXPECT_EQ(mesh.opposite(rest), o);
  } else {
    EXPECT_FALSE(mesh.is_open(h));
    EXPECT_FALSE(mesh.is_open(rest));
  }
}

// Cuts h and checks what cut promises.
void cut_and_check(TriangleMesh& mesh, std::int32_t h, std::int32_t label) {
  const std::int32_t a = mesh.from(h), b = mesh.to(h), o = mesh.opposite(h);
  const bool a_open = mesh.is_open_vertex(a), b_open = mesh.is_open_vertex(b);
  const std::int64_t chi = euler(mesh);

  const TriangleMesh::Cut c = mesh.cut(h, label);

  EXPECT_EQ(mesh.crack_of(h), label);
  EXPECT_EQ(mesh.crack_of(o), label);
  EXPECT_EQ(c.copy_of_from >= 0, a_open);
  EXPECT_EQ(c.copy_of_to >= 0, b_open);
  // One more edge always, one more vertex for each end that was on the border.
  EXPECT_EQ(euler(mesh), chi - 1 + (a_open ? 1 : 0) + (b_open ? 1 : 0));
  if (a_open) {
    EXPECT_EQ(mesh.root(c.copy_of_from), mesh.root(a));
    EXPECT_EQ(mesh.position(c.copy_of_from), mesh.position(a));
  }
}

// A run of random edits on one shape. Cuts prefer edges at the border half of the time, so that
// cracks grow and meet as well as start.
void edit_at_random(const std::string& shape, std::uint64_t seed, int edits, int validate_every) {
  TriangleMesh mesh = triangle_mesh_of(shape);
  Random random(seed);
  const double area = mesh.total_area();
  const std::int32_t inputs = mesh.face_count();
  std::vector<double> source_area(inputs);
  for (std::int32_t f = 0; f < inputs; ++f) source_area[f] = mesh.area(f);
  for (int edit = 0; edit < edits; ++edit) {
    const auto h = static_cast<std::int32_t>(random.below(3 * mesh.face_count()));
    if (random.uniform() < 0.5 || mesh.is_open(h)) {
      split_and_check(mesh, h, random.uniform(0.05, 0.95));
    } else {
      std::int32_t g = h;
      if (random.uniform() < 0.5) {
        const std::int32_t start = mesh.first_halfedge(mesh.from(h));
        const std::int32_t second = mesh.rotate(start);
        if (mesh.is_open(start) && second >= 0) g = second;
      }
      cut_and_check(mesh, g, edit);
    }
    if ((edit + 1) % validate_every == 0 || edit + 1 == edits) {
      const auto problems = validate(mesh);
      ASSERT_TRUE(problems.empty()) << shape << " seed " << seed << ": " << problems.front();
      ASSERT_NEAR(mesh.total_area(), area, 1e-12 * area);
    }
  }
  std::vector<double> kept(inputs, 0);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) kept[mesh.source_face(f)] += mesh.area(f);
  for (std::int32_t f = 0; f < inputs; ++f) {
    EXPECT_NEAR(kept[f], source_area[f], 1e-12 * area) << "source face " << f;
  }
}

TEST(TriangleMeshEdits, TheMeshIsSoundAfterEachOfAFewEdits) {
  for (const std::string& shape : shapes()) edit_at_random(shape, 11, 60, 1);
}

TEST(TriangleMeshEdits, TheMeshIsSoundAfterThousands) {
  for (const std::string& shape : shapes()) edit_at_random(shape, 7, 1500, 50);
}

RC_GTEST_PROP(TriangleMeshEdits, AnySeedKeepsAreaTopologyAndLabels, (std::uint64_t seed)) {
  const auto shape = *rc::gen::elementOf(shapes());
  edit_at_random(shape, seed, 40, 10);
  RC_ASSERT(!::testing::Test::HasFailure());
}

TEST(TriangleMeshEdits, CuttingEveryEdgeLeavesOneTrianglePerPiece) {
  for (const std::string& shape : shapes()) {
    TriangleMesh mesh = triangle_mesh_of(shape);
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      if (!mesh.is_open(h)) mesh.cut(h, 0);
    }
    EXPECT_TRUE(validate(mesh).empty()) << shape;
    EXPECT_EQ(mesh.vertex_count(), 3 * mesh.face_count()) << shape;
    EXPECT_EQ(summarize(mesh).components, mesh.face_count()) << shape;
  }
}

TEST(TriangleMeshEdits, ASlitInAClosedSurfaceIsABoundaryLoopWithTwoTips) {
  TriangleMesh mesh = triangle_mesh_of("sphere?n=6");
  const std::int32_t vertices = mesh.vertex_count();
  std::int32_t h = 0;
  for (int step = 0; step < 4; ++step) {
    mesh.cut(h, step);
    const MeshSummary s = summarize(mesh);
    EXPECT_EQ(s.boundary_loops, 1);
    EXPECT_EQ(s.euler_characteristic, 1);
    EXPECT_EQ(mesh.vertex_count(), vertices + step);
    // Go on from the tip to(h), half way round its fan.
    const std::int32_t tip = mesh.to(h);
    h = mesh.rotate(mesh.rotate(mesh.rotate(mesh.first_halfedge(tip))));
  }
  EXPECT_TRUE(validate(mesh).empty());
}

TEST(MeshSummary, CountsPartsLoopsAndGenus) {
  const MeshSummary torus = summarize(triangle_mesh_of("torus?n=24"));
  EXPECT_EQ(torus.euler_characteristic, 0);
  EXPECT_EQ(torus.genus, 1);
  const MeshSummary tube = summarize(triangle_mesh_of("cylinder?n=24&open=1"));
  EXPECT_EQ(tube.boundary_loops, 2);
  EXPECT_EQ(tube.genus, -1);
  EXPECT_EQ(tube.volume, 0);
  const MeshSummary cube = summarize(triangle_mesh_of("cube?n=2"));
  EXPECT_NEAR(cube.diagonal, std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(cube.edge_min, 0.5, 1e-12);
  EXPECT_NEAR(cube.edge_max, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(cube.worst_aspect, 2, 1e-12);
  EXPECT_EQ(summarize(TriangleMesh({}, {})).components, 0);
}

TEST(Validate, NamesAPositionThatIsNotFinite) {
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}});
  const auto problems = validate(mesh);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].find("vertex 2"), std::string::npos);
}

}  // namespace
}  // namespace craze
