#include "craze/model/failure/foreseen_failures.h"

#include <gtest/gtest.h>

#include "model/states.h"

namespace craze {
namespace {

TEST(ForeseenFailures, HoldWhereACrackHasNoInfluence) {
  const TriangleMesh mesh = test::mesh_of("plate?n=20");
  const auto near = [&](double x, double y) {
    std::int32_t nearest = 0;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      const Vec3 at(x, y, 0);
      if ((mesh.position(v) - at).norm() < (mesh.position(nearest) - at).norm()) nearest = v;
    }
    return nearest;
  };
  const Vec3 origin = mesh.position(near(-100, -100));
  const auto place = [&](double x, double y) { return near(origin.x() + x, origin.y() + y); };
  const double size = mesh.position(near(100, 100)).x() - origin.x();
  const std::int32_t cracked = place(0.2 * size, 0.2 * size), tip = place(0.4 * size, 0.2 * size);
  const std::int32_t beside = place(0.45 * size, 0.2 * size), far = place(0.8 * size, 0.8 * size);
  ForeseenFailures foreseen;
  EXPECT_EQ(foreseen.find(far), nullptr);
  foreseen.begin({far, beside, tip});
  foreseen.all()[0].failure.measure = 1;
  EXPECT_NE(foreseen.find(far), nullptr);
  EXPECT_EQ(foreseen.find(far)->node, far);
  EXPECT_EQ(foreseen.find(cracked), nullptr);
  foreseen.opened(mesh, cracked, {cracked, tip}, 0.1 * size);
  EXPECT_EQ(foreseen.find(tip), nullptr);
  EXPECT_EQ(foreseen.find(beside), nullptr);  // in reach of what the crack has changed
  EXPECT_NE(foreseen.find(far), nullptr);
  foreseen.clear();
  EXPECT_EQ(foreseen.find(far), nullptr);
}

}  // namespace
}  // namespace craze
