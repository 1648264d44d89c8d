#include "craze/mesh/edit_mesh.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "craze/base/random.h"
#include "craze/mesh/closest_point.h"
#include "craze/mesh/mesh_summary.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/mesh/validate.h"
#include "craze/shapes.h"

namespace craze {
namespace {

MeshSummary summary_of(const EditMesh& mesh) {
  std::vector<std::int32_t> kept;
  const std::vector<Triangle> triangles = mesh.compact(kept);
  std::vector<Vec3> positions;
  for (std::int32_t v : kept) positions.push_back(mesh.position(v));
  const TriangleMesh made(positions, triangles);  // throws if it is not manifold
  EXPECT_TRUE(validate(made).empty());
  // The adjacency kept through the edits is the one that the triangles imply.
  std::int32_t open = 0;
  for (std::int32_t h = 0; h < mesh.halfedge_slots(); ++h) {
    if (!mesh.is_face(h / 3)) continue;
    const std::int32_t o = mesh.opposite(h);
    open += o < 0;
    if (o < 0) continue;
    EXPECT_EQ(mesh.opposite(o), h);
    EXPECT_EQ(mesh.from(o), mesh.to(h));
    EXPECT_EQ(mesh.to(o), mesh.from(h));
    EXPECT_EQ(mesh.mark(o), mesh.mark(h));
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.is_vertex(v)) continue;
    mesh.for_each_outgoing(v, [&](std::int32_t h) { EXPECT_EQ(mesh.from(h), v); });
  }
  std::int32_t made_open = 0;
  for (std::int32_t h = 0; h < 3 * made.face_count(); ++h) made_open += made.is_open(h);
  EXPECT_EQ(open, made_open);
  return summarize(made);
}

EditMesh mesh_of(const std::string& shape) {
  const SurfaceMesh s = make_shape(shape);
  const TriangleMesh mesh(s.positions, s.triangles);
  std::vector<char> marks(s.triangles.size() * 3, 0);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) marks[h] = mesh.is_open(h) ? 1 : 0;
  return {mesh, marks};
}

RC_GTEST_PROP(EditMesh, RandomEditsKeepTheTopology, (std::uint64_t seed)) {
  const std::vector<std::string> shapes{"cube?n=1",  "sphere?n=3",          "torus?n=12",
                                        "plate?n=4", "cylinder?n=8&open=1", "strip?n=1&length=5"};
  Random random(seed);
  EditMesh mesh = mesh_of(shapes[random.below(shapes.size())]);
  const MeshSummary before = summary_of(mesh);
  for (int edit = 0; edit < 400; ++edit) {
    const auto h = static_cast<std::int32_t>(random.below(mesh.halfedge_slots()));
    if (!mesh.is_face(h / 3)) continue;
    const std::uint64_t kind = random.below(5);
    if (kind == 0) {
      mesh.split(h, 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
    } else if (kind < 3) {
      if (mesh.can_flip(h)) mesh.flip(h);
    } else if (mesh.can_collapse(h)) {
      mesh.collapse(h);
    }
    if (edit % 20 == 0) summary_of(mesh);
  }
  const MeshSummary after = summary_of(mesh);
  RC_ASSERT(after.euler_characteristic == before.euler_characteristic);
  RC_ASSERT(after.boundary_loops == before.boundary_loops);
  RC_ASSERT(after.components == before.components);
  RC_ASSERT(!::testing::Test::HasFailure());
}

TEST(EditMesh, OnlyAlongItsLineDoesAMarkedVertexGo) {
  EditMesh mesh = mesh_of("plate?n=4");
  for (std::int32_t h = 0; h < mesh.halfedge_slots(); ++h) {
    if (!mesh.is_border_vertex(mesh.from(h)) || !mesh.can_collapse(h)) continue;
    EXPECT_EQ(mesh.mark(h), 1);
    EXPECT_EQ(mesh.count_marked(mesh.from(h)), 2);
  }
}

RC_GTEST_PROP(ClosestPoint, FindsWhatASearchOfAllFacesFinds, (std::uint64_t seed)) {
  const SurfaceMesh s = make_shape("torus?n=16");
  const ClosestPoint tree(s.positions, s.triangles);
  Random random(seed);
  for (int i = 0; i < 20; ++i) {
    const Vec3 p(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 1));
    double nearest = 1e9;
    for (const Triangle& t : s.triangles) {
      const Vec3 &a = s.positions[t[0]], &b = s.positions[t[1]], &c = s.positions[t[2]];
      const Vec3 w = nearest_weights(p, a, b, c);
      RC_ASSERT(w.minCoeff() >= 0 && std::abs(w.sum() - 1) < 1e-12);
      nearest = std::min(nearest, (w[0] * a + w[1] * b + w[2] * c - p).norm());
    }
    const auto hint = static_cast<std::int32_t>(random.below(s.triangles.size()));
    const ClosestPoint::Hit hit = tree.find(p, {Vec3::Zero(), -1, hint});
    RC_ASSERT(std::abs(hit.distance - nearest) < 1e-12);
    RC_ASSERT(std::abs((hit.point - p).norm() - nearest) < 1e-12);
  }
}

TEST(ClosestPoint, TheFilterKeepsToTheAskedSideAndLabel) {
  SurfaceMesh s = make_shape("cube?n=2");  // sides in the order −x +x −y +y −z +z, 8 faces each
  std::vector<std::int32_t> sides;
  for (std::size_t f = 0; f < s.triangles.size(); ++f)
    sides.push_back(static_cast<std::int32_t>(f / 8));
  const ClosestPoint tree(s.positions, s.triangles, sides);
  const Vec3 p(0.1, 0.05, 0.45);  // nearest to +z
  EXPECT_EQ(tree.find(p).face / 8, 5);
  EXPECT_EQ(tree.find(p, {Vec3::Zero(), 1}).face / 8, 1);
  EXPECT_LT(tree.find(p, {Vec3(-1, -1, -1)}).face / 8, 5);
  EXPECT_EQ(tree.find(p, {Vec3::Zero(), 9}).face, -1);
}

}  // namespace
}  // namespace craze
