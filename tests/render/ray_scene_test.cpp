#include "craze/render/rays/ray_scene.h"

#include <gtest/gtest.h>

#include <limits>

namespace craze::render {
namespace {

TEST(RayScene, WhatLanesHoldThatAreNotActiveIsOfNoConsequence) {
  const RayScene scene({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  RayScene::Rays rays;
  for (Ray& ray : rays) {
    ray.origin = ray.direction = Vec3f::Constant(std::numeric_limits<float>::quiet_NaN());
  }
  rays[3] = {{0.25F, 0.25F, 1}, {0, 0, -1}, 0, true};
  rays[9] = {{2, 2, 1}, {0, 0, -1}, 0, true};
  RayScene::Hits hits;
  RayScene::Flags occluded;
  scene.intersect(rays, hits);
  scene.occluded(rays, occluded);
  for (int i = 0; i < RayScene::lanes; ++i) {
    EXPECT_EQ(hits[i].face, i == 3 ? 0 : -1) << i;
    EXPECT_EQ(occluded[i], i == 3) << i;
  }
  EXPECT_EQ(hits[3].distance, 1);
}

}  // namespace
}  // namespace craze::render
