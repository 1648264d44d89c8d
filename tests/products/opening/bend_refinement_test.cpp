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

TEST(BendRefinement, LeavesNoEdgeLongerThanTheLongestSideOfACrack) {
  const TriangleMesh mesh = cracked_plate();
  const auto fine = refined(mesh, 0.1);
  double longest_side = 0, longest_before = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    double& longest = mesh.crack_of(h) >= 0 ? longest_side : longest_before;
    longest = std::max(longest, length_of(mesh, h));
  }
  ASSERT_GT(longest_before, longest_side);
  ASSERT_GT(longest_side, std::sqrt(8 * bend_tolerance) * 0.1);
  for (std::int32_t h = 0; h < 3 * fine->face_count(); ++h) {
    EXPECT_LE(length_of(*fine, h), longest_side);
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
