#include "craze/model/sources/correlated_noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/analytic_surfaces.h"

namespace craze {
namespace {

/// Mean of g(x) over many points far apart.
template <class G>
double average(int n, G&& g) {
  Random places(77);
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    sum += g(Vec3(places.uniform(-500, 500), places.uniform(-500, 500), places.uniform(-500, 500)));
  }
  return sum / n;
}

TEST(CorrelatedNoise, HasMeanZeroDeviationOneAndIsNearlyNormal) {
  const CorrelatedNoise noise(0.7, Random(5));
  const double mean = average(60000, [&](const Vec3& p) { return noise.at(p); });
  const double variance = average(60000, [&](const Vec3& p) { return std::pow(noise.at(p), 2); });
  const double fourth = average(60000, [&](const Vec3& p) { return std::pow(noise.at(p), 4); });
  EXPECT_NEAR(mean, 0, 0.02);
  EXPECT_NEAR(variance, 1, 0.03);
  EXPECT_NEAR(fourth, 3, 0.5);
}

TEST(CorrelatedNoise, IsCorrelatedOverItsLengthAlikeInEveryDirection) {
  const double length = 2.5;
  const CorrelatedNoise noise(length, Random(9));
  const Vec3 directions[] = {Vec3::UnitX(), Vec3::UnitY(), Vec3(1, 1, 1).normalized()};
  for (const Vec3& d : directions) {
    const auto correlation = [&](double distance) {
      return average(
          30000, [&](const Vec3& p) { return noise.at(p) * noise.at(p + distance * length * d); });
    };
    EXPECT_NEAR(correlation(0.5), std::exp(-0.25), 0.03);
    EXPECT_NEAR(correlation(1), std::exp(-1), 0.03);
    EXPECT_NEAR(correlation(2), 0.0085, 0.03);
    EXPECT_NEAR(correlation(4), 0, 0.03);
  }
}

TEST(CorrelatedNoise, IsTheSameFieldOnEveryMesh) {
  TriangleMesh mesh = test::plate(8, 4, 0.2);
  const auto before = vertex_noise(mesh, 1, Random(1), Context{});
  for (std::int32_t h = 0; h < 60; h += 3) mesh.split_edge(h, 0.4);
  const auto after = vertex_noise(mesh, 1, Random(1), Context{});
  for (std::size_t v = 0; v < before.size(); ++v) EXPECT_EQ(before[v], after[v]);
  const auto other_seed = vertex_noise(mesh, 1, Random(2), Context{});
  EXPECT_NE(after[0], other_seed[0]);
}

TEST(CorrelatedNoise, IsContinuousAcrossItsLattice) {
  const CorrelatedNoise noise(1, Random(4));
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p(0.01 * i - 10, 0.3, -0.2);
    EXPECT_LT(std::abs(noise.at(p) - noise.at(p + Vec3(1e-6, 0, 0))), 2e-5);
  }
}

TEST(CorrelatedNoise, WhatWasFoundForOnePlaceServesThoseNearIt) {
  const CorrelatedNoise noise(1, Random(4));
  CorrelatedNoise::Impulses last;
  Random places(8);
  for (int i = 0; i < 3000; ++i) {
    const double reach = i % 10 == 0 ? 30 : 1;
    const Vec3 p(places.uniform(-reach, reach), places.uniform(-reach, reach), 0.2);
    EXPECT_EQ(noise.at(p, last), noise.at(p));
  }
}

TEST(CorrelatedNoise, WithoutALengthEveryTriangleIsDrawnByItself) {
  const TriangleMesh mesh = test::plate(60, 1, 0);
  const auto noise = face_noise(mesh, 0, Random(3), Context{});
  double sum = 0, square = 0, neighbours = 0;
  for (std::size_t f = 0; f < noise.size(); ++f) {
    sum += noise[f];
    square += noise[f] * noise[f];
    neighbours += noise[f] * noise[(f + 1) % noise.size()];
  }
  const auto n = static_cast<double>(noise.size());
  EXPECT_NEAR(sum / n, 0, 0.04);
  EXPECT_NEAR(square / n, 1, 0.05);
  EXPECT_NEAR(neighbours / n, 0, 0.04);
}

TEST(CorrelatedNoise, PlacesFarFromTheOriginDoNotBreakIt) {
  const CorrelatedNoise noise(1e-12, Random(4));
  EXPECT_TRUE(std::isfinite(noise.at(Vec3(1e300, -1e20, 3))));
}

}  // namespace
}  // namespace craze
