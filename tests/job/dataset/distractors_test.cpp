#include "craze/job/dataset/marks/distractors.h"

#include <gtest/gtest.h>

#include "craze/job/dataset/dataset_plan.h"
#include "craze/render/picture.h"

namespace craze {
namespace {

/// A square seen from straight above.
struct Sheet {
  SurfaceMesh mesh;
  render::PictureOptions options;

  Sheet() {
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    options.view.elevation = 90;
    options.view.zoom = 2;
  }
  std::vector<render::Mark> marks(const std::string& text, const Vec3& lamp) const {
    const Plan plan(text, "p.toml", dataset_schema());
    const Projection projection(render::picture_camera(mesh, options), 128, 128);
    std::vector<Vec3> places;
    for (const Vec3& p : mesh.positions) places.push_back(projection.to_render(p));
    const render::RayScene rays(places, mesh.triangles);
    return strewn_marks(plan.draw(0), mesh, rays, projection, render::Rgb::Constant(0.5f), lamp, 5);
  }
};

const Vec3 slanting = Vec3(1, 0, 1).normalized();

TEST(Distractors, OfEveryKindArePutOnTheSurfaceAsManyAsAreAsked) {
  const Sheet sheet;
  int kinds = 0;
  EXPECT_TRUE(sheet.marks("", slanting).empty());
  for (const PlanKey& key : dataset_schema().keys) {
    if (key.key.rfind("distractors.", 0) != 0) continue;
    ++kinds;
    const auto one = sheet.marks(key.key + " = 1", slanting);
    const auto three = sheet.marks(key.key + " = 3", slanting);
    EXPECT_GE(one.size(), 1u) << key.key;
    EXPECT_GE(three.size(), one.size() + 2) << key.key;
    for (const render::Mark& m : three) {
      EXPECT_NEAR(m.point.z(), 0, 1e-9) << key.key;
      EXPECT_NEAR(m.along.norm(), 1, 1e-9) << key.key;
      EXPECT_GE(m.strength, 0) << key.key;
      EXPECT_LE(m.strength, 1) << key.key;
    }
    // Those that were there stay where they were.
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(three[i].point, one[i].point) << key.key;
  }
  EXPECT_EQ(kinds, 13);
}

TEST(Distractors, ThatLieOnTheSurfaceThrowTheirShadowAwayFromTheLamp) {
  const Sheet sheet;
  for (const char* kind : {"hair", "twig", "grass", "rod", "pebble"}) {
    const auto marks = sheet.marks(std::string("distractors.") + kind + " = 1", slanting);
    ASSERT_EQ(marks.size() % 2, 0u) << kind;
    const std::size_t half = marks.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
      EXPECT_TRUE(marks[i].shadow) << kind;
      EXPECT_FALSE(marks[half + i].shadow) << kind;
      const Vec3 off = marks[i].point - marks[half + i].point;
      EXPECT_LT(off.x(), 0) << kind;
      EXPECT_NEAR(off.y(), 0, 1e-12) << kind;
    }
  }
}

}  // namespace
}  // namespace craze
