#include "craze/engine/place_impacts.h"

#include <gtest/gtest.h>

#include "craze/recipe.h"
#include "craze/recipe/check_recipe.h"
#include "craze/shapes.h"
#include "error_message.h"

namespace craze {
namespace {

Impact placed(const std::string& shape, const Impact& impact) {
  return place_impacts({impact}, make_shape(shape), {}).front();
}

Vec3 struck(const std::string& shape, const Vec3& direction) {
  Impact impact;
  impact.direction = direction;
  return placed(shape, impact).point;
}

double distance(const Vec3& a, const Vec3& b) {
  return (a - b).norm();
}

TEST(AnImpactByDirection, StrikesTheFirstPlaceOnItsWayToTheMiddle) {
  const double side = struck("cube?n=4", {0, 0, -1}).z();
  EXPECT_GT(side, 0.1);
  // The line runs through an edge of four triangles there, and on.
  EXPECT_LT(distance(struck("cube?n=4", {0, 0, -1}), {0, 0, side}), 1e-9);
  EXPECT_LT(distance(struck("cube?n=4", {0, 0, 1}), {0, 0, -side}), 1e-9);
  EXPECT_LT(distance(struck("cube?n=4", {-5, 0, 0}), {side, 0, 0}), 1e-9);
  EXPECT_LT(
      distance(struck("sphere?n=40", Vec3(1, -2, 0.5)), -struck("sphere?n=40", Vec3(-1, 2, -0.5))),
      0.01);
}

TEST(AnImpactByDirection, OfALineThroughAHoleStrikesNearby) {
  const Vec3 hit = struck("torus?n=40", {0, 0, -1});
  EXPECT_GT(hit.z(), 0);  // on the side it comes from
  EXPECT_GT(hit.norm(), 0.1);
}

TEST(AnImpactByUv, StrikesThePlaceThatHasIt) {
  const SurfaceMesh plate = make_shape("plate?n=10");
  Vec2 uv = Vec2::Zero();
  Vec3 middle = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    uv += plate.corner_uvs[3 * 57 + i] / 3;
    middle += plate.positions[plate.triangles[57][i]] / 3;
  }
  Impact impact;
  impact.uv = {uv.x(), uv.y()};
  EXPECT_LT(distance(placed("plate?n=10", impact).point, middle), 1e-9);
  impact.uv = {7, 7};
  EXPECT_NE(error_of([&] { placed("plate?n=10", impact); }).find("no triangle"), std::string::npos);
  SurfaceMesh bare = plate;
  bare.corner_uvs.clear();
  EXPECT_NE(error_of([&] { place_impacts({impact}, bare, {}); }).find("UVs"), std::string::npos);
}

TEST(AnImpactByPoint, StrikesTheNearestPlaceUpToATenthOfTheDiagonal) {
  Impact impact;
  impact.point = {0.2, 0.1, 0.1};
  EXPECT_LT(distance(placed("plate?n=10", impact).point, {0.2, 0.1, 0}), 1e-9);
  impact.point = {0.2, 0.1, 0.5};
  EXPECT_NE(error_of([&] { placed("plate?n=10", impact); }).find("impact 1"), std::string::npos);
}

TEST(AnImpact, HasItsRadiusAsPartOfTheDiagonalWhereThatIsGiven) {
  Impact impact;
  impact.radius = 0.3;
  EXPECT_EQ(placed("plate?n=10", impact).radius, 0.3);
  impact.relative_radius = 0.1;
  const Impact result = placed("plate?n=10", impact);
  EXPECT_NEAR(result.radius, 0.1 * std::sqrt(2), 1e-12);
  EXPECT_EQ(result.relative_radius, 0);  // so that the report's recipe says it once
}

TEST(AnImpact, IsPlacedInOneWay) {
  Recipe recipe;
  apply_set(recipe, "impact.0.direction=[0,0,-1]");
  EXPECT_NO_THROW(check_recipe(recipe));
  apply_set(recipe, "impact.0.uv=[0.5,0.5]");
  EXPECT_NE(error_of([&] { check_recipe(recipe); }).find("one of point, direction and uv"),
            std::string::npos);
}

}  // namespace
}  // namespace craze
