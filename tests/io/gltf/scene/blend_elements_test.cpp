// Joints and weights of new vertices.
#include "craze/io/gltf/scene/blend_elements.h"

#include <gtest/gtest.h>

#include <vector>

namespace craze {
namespace {

/// Two vertices that follow joint 0 and joint 1 alone, so heavily.
std::vector<JointSet> two_vertices(double first, double second) {
  JointSet set;
  set.joints.components = set.weights.components = 4;
  set.joints.component_type = 5121;
  const double joints[2][4] = {{0, 0, 0, 0}, {1, 0, 0, 0}};
  const double weights[2][4] = {{first, 0, 0, 0}, {second, 0, 0, 0}};
  for (int v = 0; v < 2; ++v) {
    set.joints.append(joints[v]);
    set.weights.append(weights[v]);
  }
  return {set};
}

double sum_at_the_middle(double first, double second) {
  std::vector<JointSet> sets = two_vertices(first, second);
  append_joints(sets, {{make_blend({0, 1, VertexBlend::none}, Vec3(0.5, 0.5, 0)), 0}});
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += sets[0].weights.value(2, k);
  return sum;
}

TEST(BlendedJoints, HaveTheSumOne) {
  EXPECT_EQ(sum_at_the_middle(1, 1), 1);
  EXPECT_EQ(sum_at_the_middle(0.998, 1), 1);  // as rounded to 8 bits
}

TEST(BlendedJoints, HaveTheSumOfTheirCornersWhereAFileHasAnother) {
  EXPECT_FLOAT_EQ(static_cast<float>(sum_at_the_middle(0.5, 0.5)), 0.5F);
  EXPECT_FLOAT_EQ(static_cast<float>(sum_at_the_middle(0.5, 1)), 0.75F);
  EXPECT_EQ(sum_at_the_middle(0, 0), 0);
}

}  // namespace
}  // namespace craze
