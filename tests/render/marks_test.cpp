#include "craze/render/material/marks.h"

#include <gtest/gtest.h>

namespace craze::render {
namespace {

constexpr float pixel = 0.001f;

Mark line() {
  Mark m;
  m.half_width = 0.02;
  m.half_length = 0.5;
  m.softness = 0.001;
  m.depth = 1;
  m.color = Rgb::Constant(0.3f);
  return m;
}

float cover(const Mark& mark, float x, float y) {
  return marks_at({mark}, {x, y, 0}, pixel).cover;
}

TEST(Marks, OfLinesThatTaperCloseAtTheirEnds) {
  Mark m = line();
  EXPECT_EQ(cover(m, 0.48f, 0.015f), 1);
  m.taper = 1;
  EXPECT_EQ(cover(m, 0, 0.015f), 1);
  EXPECT_EQ(cover(m, 0.48f, 0.015f), 0);
}

TEST(Marks, ThatAreTwistedBendToEitherSide) {
  Mark m = line();
  m.twist = 1;
  EXPECT_EQ(cover(m, 0.4f, 0.064f), 1);
  EXPECT_EQ(cover(m, -0.4f, -0.064f), 1);
  EXPECT_EQ(cover(m, -0.4f, 0.064f), 0);
}

TEST(Marks, ThatAreBlobsMayBeLongerThanWide) {
  Mark m = line();
  m.shape = MarkShape::blob;
  EXPECT_EQ(cover(m, 0.4f, 0), 1);
  EXPECT_EQ(cover(m, 0, 0.1f), 0);
  m.half_length = 0;
  EXPECT_EQ(cover(m, 0.4f, 0), 0);
}

TEST(Marks, ThatAreShadowsDimTheLightAndCoverNothing) {
  Mark m = line();
  m.shadow = true;
  m.strength = 0.4f;
  const MarkSample sample = marks_at({m}, Vec3f::Zero(), pixel);
  EXPECT_FLOAT_EQ(sample.light, 0.6f);
  EXPECT_EQ(sample.cover, 0);
}

TEST(Marks, StandOutWhereTheyAreNotEngraved) {
  Mark m = line();
  m.groove = 0.5f;
  const float engraved = marks_at({m}, {0, 0.01f, 0}, pixel).tilt.y();
  m.groove = -0.5f;
  EXPECT_LT(engraved, 0);
  EXPECT_FLOAT_EQ(marks_at({m}, {0, 0.01f, 0}, pixel).tilt.y(), -engraved);
}

TEST(Marks, LookTheSameInOtherUnits) {
  Mark m = line();
  m.bend = 0.3;
  m.twist = -0.7;
  m.taper = 0.5;
  const std::vector<Mark> big = scaled({m}, Vec3(1, 2, 0), 4);
  for (float x = -0.5f; x < 0.5f; x += 0.043f) {
    for (float y = -0.1f; y < 0.1f; y += 0.007f) {
      EXPECT_NEAR(marks_at(big, {4 * (x - 1), 4 * (y - 2), 0}, 4 * pixel).cover, cover(m, x, y),
                  1e-3);
    }
  }
}

}  // namespace
}  // namespace craze::render
