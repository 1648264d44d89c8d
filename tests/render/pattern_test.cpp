#include "craze/render/material/pattern.h"

#include <gtest/gtest.h>

#include <cmath>

namespace craze::render {
namespace {

constexpr float fine_pixel = 0.0005f;

/// The share of a square whose colour is another than the ground's.
double changed(const Pattern& pattern) {
  int other = 0, all = 0;
  for (float x = 0; x < 1; x += 0.0083f) {
    for (float y = 0; y < 1; y += 0.0083f, ++all) {
      other += std::abs(pattern_at(pattern, {x, y, 0}, fine_pixel).tint[0] - 1) > 0.1f;
    }
  }
  return static_cast<double>(other) / all;
}

TEST(Pattern, ThatIsNoneLeavesTheGroundAsItIs) {
  const PatternSample sample = pattern_at({}, {0.3f, 0.2f, 0}, fine_pixel);
  EXPECT_TRUE((sample.tint == Rgb::Ones()).all());
  EXPECT_TRUE(sample.tilt.isZero());
}

TEST(Pattern, FlakesOffOnAboutTheShareThatIsAsked) {
  Pattern p;
  p.below = Rgb::Constant(0.5f);
  p.flake_size = 0.01f;
  for (const float share : {0.04f, 0.15f, 0.3f, 0.5f, 0.7f, 0.9f}) {
    p.flaking = share;
    EXPECT_NEAR(changed(p), share, 0.08) << share;
  }
}

TEST(Pattern, HasAsMuchMortarAsJointsOfBricksHave) {
  Pattern p;
  p.bricks = 0.5f;
  p.brick_size = 0.1f;
  p.mortar = 0.1f;
  // A course has a joint of its length and one across for every two heights.
  EXPECT_NEAR(changed(p), 0.1 + 0.05 - 0.005, 0.03);
  p.angle = 0.7f;
  EXPECT_NEAR(changed(p), 0.145, 0.03);
}

TEST(Pattern, HasWiderVeinsWhereTheyAreToBeWider) {
  Pattern p;
  p.veins = 0.8f;
  p.vein_width = 0.05f;
  const double narrow = changed(p);
  p.vein_width = 0.4f;
  EXPECT_GT(narrow, 0.005);
  EXPECT_GT(changed(p), 2 * narrow);
}

TEST(Pattern, HasSpecksOfManyColours) {
  Pattern p;
  p.specks = 0.6f;
  p.speck_size = 0.01f;
  const Rgb one = pattern_at(p, {0.1f, 0.1f, 0}, fine_pixel).tint;
  EXPECT_TRUE((pattern_at(p, {0.1f, 0.1f, 0}, fine_pixel).tint == one).all());
  EXPECT_FALSE((pattern_at(p, {0.7f, 0.3f, 0}, fine_pixel).tint == one).any());
  EXPECT_NE(one[0] / one[1], 1);
}

TEST(Pattern, LiesElsewhereWhereItIsShifted) {
  Pattern p;
  p.flaking = 0.4f;
  p.below = Rgb::Constant(0.5f);
  Pattern moved = p;
  moved.shift = {0.25f, 0, 0};
  int differ = 0;
  for (float x = 0; x < 1; x += 0.01f) {
    const Rgb here = pattern_at(p, {x + 0.25f, 0.3f, 0}, fine_pixel).tint;
    EXPECT_NEAR(pattern_at(moved, {x, 0.3f, 0}, fine_pixel).tint[0], here[0], 0.02);
    differ += pattern_at(p, {x, 0.3f, 0}, fine_pixel).tint[0] != here[0];
  }
  EXPECT_GT(differ, 20);
}

}  // namespace
}  // namespace craze::render
