#include "craze/products/opening/bend_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "products/distance/surfaces.h"

namespace craze {
namespace {

/// A plate of eight by eight squares, cut along one edge in eight.
TriangleMesh cracked_plate() {
  TriangleMesh mesh = test::plate(8, 0.3);
  test::cut_at_random(mesh, mesh.face_count() / 8, 0, 3);
  return mesh;
}

std::shared_ptr<const TriangleMesh> refined(const TriangleMesh& mesh, double length) {
  return refined_to_bend(mesh, std::vector<double>(mesh.positions().size(), 0.0), length);
}

double length_of(const TriangleMesh& mesh, std::int32_t h) {
  return (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
}

bool touches_crack(const TriangleMesh& mesh, std::int32_t h) {
  const std::int32_t o = mesh.opposite(h);
  bool touches = mesh.crack_of(h) >= 0;
  if (o < 0) return touches;
  for (const std::int32_t side : {TriangleMesh::next(o), TriangleMesh::prev(o)}) {
    touches = touches || mesh.crack_of(side) >= 0;
  }
  return touches;
}

/// The ends of the sides of cracks, ascending.
std::vector<std::array<std::int32_t, 2>> crack_sides(const TriangleMesh& mesh) {
  std::vector<std::array<std::int32_t, 2>> sides;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.crack_of(h) >= 0) sides.push_back({mesh.from(h), mesh.to(h)});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

TEST(BendRefinement, EndsAndKeepsAreaAndCracksWhoseSidesAreLongerThanItsTolerance) {
  const TriangleMesh mesh = cracked_plate();
  for (const double length : {0.1, 0.03}) {
    const auto fine = refined(mesh, length);
    ASSERT_NE(fine, nullptr);
    EXPECT_GT(fine->face_count(), mesh.face_count());
    EXPECT_NEAR(fine->total_area(), mesh.total_area(), 1e-12 * mesh.total_area());
    EXPECT_EQ(crack_sides(*fine), crack_sides(mesh));
  }
}

TEST(BendRefinement, EdgesAreWithinItsToleranceButForThoseBesideALongerSideOfACrack) {
  const double bound = std::sqrt(8 * bend_tolerance) * 0.1;
  const auto fine = refined(cracked_plate(), 0.1);
  double longest_side = 0;
  for (std::int32_t h = 0; h < 3 * fine->face_count(); ++h) {
    if (fine->crack_of(h) >= 0) longest_side = std::max(longest_side, length_of(*fine, h));
  }
  ASSERT_GT(longest_side, bound);
  for (std::int32_t h = 0; h < 3 * fine->face_count(); ++h) {
    EXPECT_LE(length_of(*fine, h), longest_side);
    const std::int32_t f = TriangleMesh::face_of(h);
    bool beside = false;
    for (std::int32_t i = 3 * f; i < 3 * f + 3; ++i) beside = beside || touches_crack(*fine, i);
    if (!beside) EXPECT_LE(length_of(*fine, h), bound);
  }
}

TEST(BendRefinement, LeavesAMeshAloneThatIsFineEnoughOrFarFromCracks) {
  const TriangleMesh mesh = cracked_plate();
  EXPECT_EQ(refined(mesh, 10), nullptr);
  EXPECT_EQ(refined_to_bend(mesh, std::vector<double>(mesh.positions().size(), 100.0), 0.1),
            nullptr);
}

}  // namespace
}  // namespace craze
