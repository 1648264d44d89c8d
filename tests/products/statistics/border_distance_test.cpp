#include "craze/products/statistics/measures/border_distance.h"

#include <gtest/gtest.h>

#include "craze/base/random.h"
#include "craze/products/statistics/graph/graph_input.h"

namespace craze {
namespace {

TEST(BorderDistance, IsThatToTheNearestSegmentWhateverTheLimit) {
  Random random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i) {
    points.emplace_back(random.uniform(0, 1), random.uniform(0, 1), 0);
  }
  points.emplace_back(0.5, 0, 0);
  const std::vector<BorderSegment> border = {{{0, 0, 0}, {1, 0, 0}}};
  for (const double limit : {1e-300, 1e-12, 0.004, 0.1, 2.0}) {
    const std::vector<char> near = near_border(points, border, limit);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(near[i] != 0, points[i].y() <= limit) << limit;
    }
  }
}

TEST(BorderDistance, PointsOnALineHaveNoWindow) {
  CrackGraphInput line;
  for (const double t : {0.0, 0.3, 0.6, 1.0}) line.points.emplace_back(t, t / 3, 0);
  line.normals.assign(4, Vec3::UnitZ());
  EXPECT_TRUE(find_window(line).has_value());       // they span a box in this frame
  const Vec3 tilted = Vec3(1, -3, 0).normalized();  // and in this one nothing but rounding
  line.normals.assign(4, tilted);
  EXPECT_FALSE(find_window(line).has_value());
}

}  // namespace
}  // namespace craze
