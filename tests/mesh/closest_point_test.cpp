// Nearest points with a filter, against a look at every face.
#include "craze/mesh/closest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "craze/shapes.h"

namespace craze {
namespace {

double nearest_by_all(const SurfaceMesh& mesh, const ClosestPoint& tree, const Vec3& p,
                      const ClosestPoint::Filter& filter) {
  double least = filter.farthest;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (!tree.accepts(static_cast<std::int32_t>(f), filter)) continue;
    const Triangle& t = mesh.triangles[f];
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3 w = nearest_weights(p, a, b, c);
    least = std::min(least, (w[0] * a + w[1] * b + w[2] * c - p).norm());
  }
  return least;
}

TEST(ClosestPoint, IsThatOfTheFacesThatTheFilterLetsThrough) {
  for (const char* shape : {"sphere?n=8", "cube", "cup?n=24"}) {
    SCOPED_TRACE(shape);
    const SurfaceMesh mesh = make_shape(shape);
    const ClosestPoint tree(mesh.positions, mesh.triangles);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-1.2, 1.2);
    const auto vector = [&]() {
      return Vec3(coordinate(random), coordinate(random), coordinate(random));
    };
    int none = 0, some = 0;
    for (int i = 0; i < 300; ++i) {
      ClosestPoint::Filter filter;
      if (i % 3 > 0) {
        filter.normal = vector().normalized();
        filter.least = coordinate(random) * 0.8;
      }
      if (i % 2 > 0) filter.farthest = std::abs(coordinate(random)) / 2;
      const Vec3 p = vector();
      const ClosestPoint::Hit hit = tree.find(p, filter);
      const double least = nearest_by_all(mesh, tree, p, filter);
      if (hit.face < 0) {
        ++none;
        EXPECT_EQ(least, filter.farthest);
        continue;
      }
      ++some;
      EXPECT_TRUE(tree.accepts(hit.face, filter));
      EXPECT_NEAR(hit.distance, least, 1e-12);
      EXPECT_NEAR((hit.point - p).norm(), hit.distance, 1e-12);
    }
    EXPECT_GT(none, 10);
    EXPECT_GT(some, 100);
  }
}

}  // namespace
}  // namespace craze
