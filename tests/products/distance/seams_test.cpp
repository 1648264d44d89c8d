#include "craze/products/distance/seams.h"

#include <gtest/gtest.h>

#include "craze/products/distance/nearby_cracks.h"
#include "products/distance/surfaces.h"

namespace craze {
namespace {

TEST(Seams, FindTheCracksOfAMeshThatWasWrittenAndReadAgain) {
  TriangleMesh cut = test::plate(12, 0.3);
  test::cut_at_random(cut, cut.face_count(), 0, 4);
  const TriangleMesh read(cut.positions(), cut.triangles());
  // A crack of one edge separates no vertex: a file cannot hold it.
  std::vector<std::int32_t> opened;
  for (const std::int32_t h : crack_sides(cut)) {
    if (read.is_open(h)) opened.push_back(h);
  }
  EXPECT_FALSE(opened.empty());
  EXPECT_EQ(seam_sides(read), opened);
}

TEST(Seams, FindThePartsWhereOneSideWasSplitAndTheOtherWasNot) {
  TriangleMesh cut = test::torus(14);
  test::cut_at_random(cut, 400, 0, 4);
  Random random(8);
  int split = 0;
  for (const std::int32_t h : crack_sides(cut)) {
    if (random.uniform() > 0.3) continue;
    cut.split_edge(h, random.uniform(0.2, 0.8));
    ++split;
  }
  ASSERT_GT(split, 50);
  const TriangleMesh read(cut.positions(), cut.triangles());
  std::vector<std::int32_t> opened;
  for (const std::int32_t h : crack_sides(cut)) {
    if (read.is_open(h)) opened.push_back(h);
  }
  EXPECT_EQ(seam_sides(read), opened);
}

TEST(Seams, AnOuterBorderIsNone) {
  EXPECT_TRUE(seam_sides(test::plate(5, 0.2)).empty());
}

}  // namespace
}  // namespace craze
