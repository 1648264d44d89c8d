// Needles beside a crack that would turn over as it opens.
#include <gtest/gtest.h>

#include <cstring>

#include "craze/products/opening/turned_faces.h"
#include "craze/shapes.h"

namespace craze {
namespace {

/// A plate that moves as a whole.
struct Plate {
  SurfaceMesh surface = make_shape("plate?n=24");
  std::vector<Vec3> shift;

  Plate() : shift(surface.positions.size(), Vec3(0.01, 0, 0)) {}
};

TEST(TurnedFaces, AreNoneWhereAllMovesAlike) {
  const Plate plate;
  const TriangleMesh mesh(plate.surface.positions, plate.surface.triangles);
  std::vector<Vec3> moved = mesh.positions();
  for (Vec3& p : moved) p += Vec3(0.3, -2, 7);
  EXPECT_TRUE(turned_faces(mesh, moved).empty());
}

TEST(TurnedFaces, MoveAsOneAndAllElseAsItDid) {
  Plate plate;
  std::int32_t apex = -1;  // in the middle of the plate
  for (std::int32_t v = 0; v < static_cast<std::int32_t>(plate.shift.size()); ++v) {
    if (apex < 0 || plate.surface.positions[v].norm() < plate.surface.positions[apex].norm()) {
      apex = v;
    }
  }
  plate.shift[apex] = Vec3(0.2, 0.1, 0);  // past its neighbours
  const TriangleMesh mesh(plate.surface.positions, plate.surface.triangles);
  std::vector<Vec3> moved = mesh.positions();
  for (std::size_t v = 0; v < moved.size(); ++v) moved[v] += plate.shift[v];
  ASSERT_FALSE(turned_faces(mesh, moved).empty());
  const std::vector<Vec3> together = needles_moved_as_one(mesh, plate.shift);
  int others = 0;
  Vec3 before = Vec3::Zero(), after = Vec3::Zero();
  for (std::size_t v = 0; v < moved.size(); ++v) {
    moved[v] = mesh.positions()[v] + together[v];
    others += std::memcmp(&together[v], &plate.shift[v], sizeof(Vec3)) == 0 ? 1 : 0;
    before += plate.shift[v];
    after += together[v];
  }
  EXPECT_TRUE(turned_faces(mesh, moved).empty());
  EXPECT_GT(others, mesh.vertex_count() - 20);
  EXPECT_LT((before - after).norm(), 1e-12);
}

TEST(TurnedFaces, ThatAreManyAreLeftAlone) {
  Plate plate;
  for (std::size_t v = 0; v < plate.shift.size(); v += 2) plate.shift[v] = Vec3(0.3, 0, 0);
  const TriangleMesh mesh(plate.surface.positions, plate.surface.triangles);
  EXPECT_EQ(needles_moved_as_one(mesh, plate.shift), plate.shift);
}

}  // namespace
}  // namespace craze
