// Patterns whose statistics are known exactly or by theory, measured by the code under test.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "craze/products/statistics/measures/cells.h"
#include "craze/products/statistics/measures/pattern.h"
#include "craze/products/statistics/null_models/null_models.h"
#include "craze/products/statistics/statistics.h"

namespace craze {
namespace {

using std::numbers::pi;

/// Nothing simplified, and only angles of 180° and more make a node irregular: the mosaic as it is.
StatisticsOptions exact() {
  StatisticsOptions o;
  o.simplify = 0;
  o.tolerance = 1e-6;
  return o;
}

void expect_within(const Estimate& e, double truth, double errors = 4) {
  ASSERT_TRUE(std::isfinite(e.value));
  ASSERT_GT(e.error, 0);
  EXPECT_NEAR(e.value, truth, errors * e.error);
}

TEST(KnownPatterns, SquaresHaveFourSidesAndFourCornersPerNode) {
  const Statistics s = compute_statistics(null_graph(NullModel::square, 400, 1));
  EXPECT_EQ(s.cells, 19 * 19);
  EXPECT_NEAR(s.root_area.value, 1, 1e-12);
  EXPECT_NEAR(s.area_over_perimeter.value, 0.5, 1e-12);
  EXPECT_NEAR(s.sides.value, 4, 1e-12);
  EXPECT_NEAR(s.corner_degree.value, 4, 1e-12);
  EXPECT_NEAR(s.regular.value, 1, 1e-12);
  EXPECT_NEAR(s.sides_from_nodes.value, 4, 1e-12);
  EXPECT_NEAR(s.crosses.value, 1, 1e-12);
  EXPECT_NEAR(s.circularity.value, pi / 4, 1e-12);
  EXPECT_NEAR(s.area_cv.value, 0, 1e-9);
  EXPECT_NEAR(s.edge_cv.value, 0, 1e-9);
  EXPECT_NEAR(s.tortuosity.value, 1, 1e-12);
  EXPECT_NEAR(s.length_per_area.value, 2, 1e-12);
  EXPECT_TRUE(std::isnan(s.gamma_shape.value)) << "equal areas follow no law";
}

TEST(KnownPatterns, HoneycombsHaveSixSidesAndOnlyYs) {
  const Statistics s = compute_statistics(null_graph(NullModel::hexagonal, 900, 1));
  EXPECT_NEAR(s.root_area.value, 1, 1e-12);
  EXPECT_NEAR(s.sides.value, 6, 1e-12);
  EXPECT_NEAR(s.corner_degree.value, 3, 1e-12);
  EXPECT_NEAR(s.sides_from_nodes.value, 6, 1e-12);
  EXPECT_NEAR(s.y_fraction.value, 1, 1e-12);
  EXPECT_NEAR(s.angle_min.value, 120, 1e-9);
  EXPECT_NEAR(s.angle_max.value, 120, 1e-9);
  EXPECT_NEAR(s.circularity.value, pi / (2 * std::sqrt(3.0)), 1e-12);
  EXPECT_NEAR(1 / s.area_over_perimeter.value, std::sqrt(2 * std::sqrt(3.0)), 1e-12);
}

TEST(KnownPatterns, BricksHaveFourSidesAlthoughSixJunctions) {
  const Statistics s = compute_statistics(null_graph(NullModel::brick, 900, 1));
  EXPECT_NEAR(s.sides.value, 4, 1e-12);
  EXPECT_NEAR(s.sides_combinatorial.value, 6, 1e-12);
  EXPECT_NEAR(s.corner_degree.value, 2, 1e-12);
  EXPECT_NEAR(s.regular.value, 0, 1e-12);
  EXPECT_NEAR(s.sides_from_nodes.value, 4, 1e-12);
  EXPECT_NEAR(s.t_fraction.value, 1, 1e-12);
  EXPECT_NEAR(s.leg_angle.value, 90, 1e-9);
  EXPECT_NEAR(s.angle_max.value, 180, 1e-9);
  // Twice as much length along the rows as across: |2 − 1| / 3.
  EXPECT_NEAR(s.anisotropy.value, 1.0 / 3, 0.02);
  EXPECT_NEAR(std::remainder(s.direction.value, 180), 0, 1e-9);
}

TEST(KnownPatterns, VoronoiCellsHaveTheirExactConstants) {
  const Statistics s = compute_statistics(null_graph(NullModel::poisson_voronoi, 6000, 2), exact());
  EXPECT_NEAR(s.mean_degree.value, 3, 1e-12);
  EXPECT_NEAR(s.corner_degree.value, 3, 1e-12);
  expect_within(s.mean_area, 1);
  expect_within(s.sides, 6);
  expect_within(s.sides_combinatorial, 6);
  EXPECT_NEAR(s.length_per_area.value, 2, 0.03);
  expect_within(s.area_over_perimeter, 0.5);
  expect_within(s.area_cv, 0.5294);  // variance 0.2802 (Gilbert 1962)
  EXPECT_NEAR(s.circularity.value, 0.73, 0.01);
  EXPECT_GT(s.gamma_over_lognormal.value, 0) << "their areas are close to a gamma law";
  EXPECT_NEAR(s.gamma_shape.value, 3.57, 0.3);
}

TEST(KnownPatterns, AFifthToAQuarterOfVoronoiNodesPassForTs) {
  StatisticsOptions o;
  o.simplify = 0;
  const Statistics s = compute_statistics(null_graph(NullModel::poisson_voronoi, 6000, 5), o);
  EXPECT_NEAR(s.t_fraction.value, 0.23, 0.02);
  EXPECT_NEAR(s.y_fraction.value, 0.19, 0.02);
}

TEST(KnownPatterns, OrthogonalSplittingGivesRectanglesAndTs) {
  const Statistics s = compute_statistics(null_graph(NullModel::orthogonal_splitting, 4000, 3));
  EXPECT_GT(s.t_fraction.value, 0.98);
  EXPECT_EQ(s.y_fraction.value, 0);
  EXPECT_NEAR(s.sides.value, 4, 1e-9);
  EXPECT_NEAR(s.area_cv.value, 0.25, 0.03);
  EXPECT_NEAR(s.circularity.value, 0.74, 0.015);
  EXPECT_GT(s.anisotropy_null.value * 3, s.anisotropy.value) << "both axes are used alike";
  EXPECT_LT(s.direction_entropy.value, 0.4);
}

TEST(KnownPatterns, StitAreasSpreadAsThoseOfALineProcess) {
  const Statistics s = compute_statistics(null_graph(NullModel::stit, 8000, 4), exact());
  expect_within(s.area_cv, std::sqrt(pi * pi / 2 - 1));  // Miles 1964: E A² = (π²/2) (E A)²
  expect_within(s.length_per_area, std::sqrt(pi));
  expect_within(s.sides, 4);
  expect_within(s.sides_combinatorial, 6);
  EXPECT_NEAR(s.t_fraction.value, 1, 1e-12);
  EXPECT_NEAR(s.circularity.value, 0.52, 0.015);
  EXPECT_NEAR(s.anisotropy.value, 0, 3.5 * s.anisotropy_null.value);
}

TEST(KnownPatterns, SidesFollowFromJunctionFractions) {
  // v̄ = n̄(1+p)/(n̄−2) holds for every convex mosaic; the two sides are measured on other things.
  for (const NullModel model : all_null_models) {
    const Statistics s = compute_statistics(null_graph(model, 2500, 7), exact());
    const double expected = s.sides.value * (1 + s.regular.value) / (s.sides.value - 2);
    EXPECT_NEAR(s.corner_degree.value, expected, 0.05) << to_string(model);
  }
}

TEST(KnownPatterns, WeightsTakeTheWindowsBiasOffTheAreas) {
  double plain_area = 0, plain_count = 0, area = 0, count = 0;
  const StatisticsOptions o;
  for (int k = 0; k < 200; ++k) {
    const CrackGraphInput graph = null_graph(NullModel::poisson_voronoi, 36, 100 + k);
    const Pattern pattern(graph, o);
    const auto sectors = all_sector_angles(pattern.raw, {0, 0});
    for (const Cell& c : find_cells(pattern.raw, sectors, 0, {}, pattern.window)) {
      if (c.border) continue;
      plain_area += c.area;
      plain_count += 1;
      area += c.weight * c.area;
      count += c.weight;
    }
  }
  EXPECT_LT(plain_area / plain_count, 0.97) << "large cells are cut off more often";
  EXPECT_NEAR(area / count, 1, 0.02);
}

TEST(KnownPatterns, MeasurementsDoNotDependOnTheUnitOrTheSeedOfTheErrors) {
  CrackGraphInput graph = null_graph(NullModel::stit, 500, 9);
  const Statistics s = compute_statistics(graph);
  for (Vec3& p : graph.points) p *= 1000;
  graph.surface_area *= 1e6;
  StatisticsOptions o;
  o.bootstrap.seed = 99;
  const Statistics t = compute_statistics(graph, o);
  EXPECT_NEAR(t.root_area.value, 1000 * s.root_area.value, 1e-6);
  EXPECT_NEAR(t.area_cv.value, s.area_cv.value, 1e-9);
  EXPECT_NEAR(t.edge_cv.value, s.edge_cv.value, 1e-9);
  EXPECT_EQ(t.t_fraction.value, s.t_fraction.value);
  EXPECT_NEAR(t.area_cv.error / s.area_cv.error, 1, 0.5);
}

}  // namespace
}  // namespace craze
