#include "craze/products/maps/groove.h"

#include <gtest/gtest.h>

namespace craze {
namespace {

/// The mean of f over the strip of `width` around d.
template <class Function>
double mean_over(double d, double width, Function&& f) {
  const int n = 20000;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += f(d + ((i + 0.5) / n - 0.5) * width);
  return sum / n;
}

TEST(Groove, MeansAreTheIntegralsOverTheStrip) {
  for (const double half : {0.02, 0.3, 1.0}) {
    for (const double width : {0.01, 0.5, 3.0}) {
      for (const double d : {0.0, 0.013, 0.29, 0.31, 0.99, 2.0}) {
        const auto inside = [half](double x) { return std::abs(x) < half ? 1.0 : 0.0; };
        const auto depth = [half](double x) { return std::max(0.0, 1 - std::abs(x) / half); };
        EXPECT_NEAR(covered_share(d, half, width), mean_over(d, width, inside), 1e-3);
        EXPECT_NEAR(mean_depth(d, half, width), mean_over(d, width, depth), 1e-4);
      }
    }
  }
}

TEST(Groove, IsDarkerTheDeeperAndNarrowerItIs) {
  EXPECT_EQ(groove_light(0.2, 0.2, 1), 1);
  EXPECT_EQ(groove_light(0.1, 0.2, 0), 1);
  EXPECT_LT(groove_light(0, 0.01, 10), 1e-3);
  for (double d = 0; d < 0.19; d += 0.01) {
    EXPECT_LT(groove_light(d, 0.2, 0.3), groove_light(d + 0.01, 0.2, 0.3));
    EXPECT_LT(groove_light(d, 0.2, 0.4), groove_light(d, 0.2, 0.3));
  }
}

// Two walls at 45 degrees: at the bottom the wall across fills half of what it sees.
TEST(Groove, AtTheBottomOfARightAngleSeesHalfTheSky) {
  EXPECT_NEAR(groove_light(0, 1, 1), 0.5, 1e-12);
}

}  // namespace
}  // namespace craze
