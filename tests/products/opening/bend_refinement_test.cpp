#include "craze/products/opening/bend_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

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

TEST(BendRefinement, LeavesNoEdgeNearCracksLongerThanItsTolerance) {
  const TriangleMesh mesh = cracked_plate();
  for (const double length : {0.1, 0.03}) {
    const auto fine = refined(mesh, length);
    ASSERT_NE(fine, nullptr);
    EXPECT_NEAR(fine->total_area(), mesh.total_area(), 1e-12 * mesh.total_area());
    for (std::int32_t h = 0; h < 3 * fine->face_count(); ++h) {
      EXPECT_LE(length_of(*fine, h), std::sqrt(8 * bend_tolerance) * length);
    }
  }
}

TEST(BendRefinement, SplitsBothSidesOfACrackAlike) {
  const auto fine = refined(cracked_plate(), 0.03);
  std::map<std::pair<std::array<double, 2>, std::array<double, 2>>, int> sides;
  for (std::int32_t h = 0; h < 3 * fine->face_count(); ++h) {
    if (fine->crack_of(h) < 0) continue;
    const auto place = [&](std::int32_t v) {
      return std::array<double, 2>{fine->position(v).x(), fine->position(v).y()};
    };
    ++sides[std::minmax(place(fine->from(h)), place(fine->to(h)))];
  }
  EXPECT_FALSE(sides.empty());
  for (const auto& [ends, count] : sides) EXPECT_EQ(count, 2);
}

TEST(BendRefinement, LeavesAMeshAloneThatIsFineEnoughOrFarFromCracks) {
  const TriangleMesh mesh = cracked_plate();
  EXPECT_EQ(refined(mesh, 10), nullptr);
  EXPECT_EQ(refined_to_bend(mesh, std::vector<double>(mesh.positions().size(), 100.0), 0.1),
            nullptr);
}

}  // namespace
}  // namespace craze
