// Openings that ask for more than the surface is large.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "products/solids/solid_checks.h"

namespace craze {
namespace {

TEST(BoundedOpenings, AreAsLargeAsTheSurfaceAndSaySo) {
  const Result result = test::cracked_shape("plate?n=10", "mud", 0.2);
  for (const double huge : {1e6, 1e300, -1e300}) {
    for (const int key : {0, 1, 2}) {
      SCOPED_TRACE(key);
      PostParameters post;
      post.gap = key == 0 ? std::abs(huge) : 0.05;
      post.curl = key == 1 ? huge : 0;
      post.wall = key == 2 ? std::abs(huge) : 0.01;
      const Opening opening(result, post, {});
      const auto& said = opening.warnings();
      EXPECT_GE(std::count_if(said.begin(), said.end(),
                              [](const std::string& warning) {
                                return warning.find("than the surface is large") !=
                                           std::string::npos ||
                                       warning.find("has room for") != std::string::npos;
                              }),
                1)
          << huge;
      for (const Vec3& p : opening.mesh().positions) {
        ASSERT_TRUE(p.allFinite());
        ASSERT_LT(p.norm(), 10);
      }
    }
  }
}

}  // namespace
}  // namespace craze
