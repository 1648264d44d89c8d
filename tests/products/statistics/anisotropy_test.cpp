#include "craze/products/statistics/measures/anisotropy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "craze/base/random.h"

namespace craze {
namespace {

using std::numbers::pi;

/// Lines that touch nothing, on a wide grid, of random lengths.
CrackGraphInput scattered(int count, std::uint64_t seed, double mean, double spread) {
  Random random(seed);
  LineSet set;
  for (int i = 0; i < count; ++i) {
    const double angle = mean + spread * (random.uniform() - 0.5);
    const Vec3 half = random.uniform(0.1, 1) * Vec3(std::cos(angle), std::sin(angle), 0);
    const Vec3 middle(4.0 * (i % 50), 4.0 * (i / 50), 0);
    set.points.push_back(middle - half);
    set.points.push_back(middle + half);
    set.edges.push_back({2 * i, 2 * i + 1});
  }
  return graph_from_lines(set);
}

TEST(Anisotropy, RandomDirectionsGiveTheNullInTheSquareMean) {
  double ratio = 0;
  constexpr int repeats = 300;
  for (int k = 0; k < repeats; ++k) {
    const Anisotropy a =
        measure_anisotropy(CrackGraph(scattered(100, k + 1, 0, pi)), Vec3::UnitX(), {0, 1});
    ratio += std::pow(a.strength.value / a.null.value, 2) / repeats;
  }
  EXPECT_NEAR(ratio, 1, 4 / std::sqrt(repeats));  // S² is exponential: its spread is its mean
}

TEST(Anisotropy, ANarrowFanHasItsDirectionAndWidth) {
  const double mean = 160 * pi / 180, spread = 20 * pi / 180;
  const Anisotropy a =
      measure_anisotropy(CrackGraph(scattered(2000, 3, mean, spread)), Vec3::UnitX(), {200, 1});
  EXPECT_NEAR(a.direction.value, 160, 4 * a.direction.error);
  EXPECT_LT(a.direction.error, 0.5);
  EXPECT_NEAR(a.rms_deviation.value, 20 / std::sqrt(12.0), 0.3);
  EXPECT_NEAR(a.strength.value, std::sin(spread) / spread, 0.01);
  EXPECT_LT(a.entropy.value, 0.45);
}

TEST(Anisotropy, DirectionsTurnWithTheAxis) {
  const CrackGraph graph(scattered(500, 3, 1.0, 0.1));
  const double from_x = measure_anisotropy(graph, Vec3::UnitX(), {0, 1}).direction.value;
  const double from_y = measure_anisotropy(graph, Vec3::UnitY(), {0, 1}).direction.value;
  EXPECT_NEAR(std::remainder(from_x - from_y - 90, 180), 0, 1e-9);
}

}  // namespace
}  // namespace craze
