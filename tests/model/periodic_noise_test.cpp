// Noise on a tile.
#include <gtest/gtest.h>

#include <cmath>

#include "craze/base/tile_noise.h"
#include "craze/model/sources/correlated_noise.h"

namespace craze {
namespace {

TEST(PeriodicNoise, IsTheSameAPeriodAway) {
  const double side = 2.5;
  for (const double length : {0.05, 0.3, 1.0, 40.0}) {
    const CorrelatedNoise noise(length, Random(5, 1), {side});
    const Random place(6, 0);
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Vec3 p(side * place.uniform_at(2 * i), side * place.uniform_at(2 * i + 1), 0);
      EXPECT_NEAR(noise.at(p), noise.at(p + Vec3(side, 0, 0)), 1e-6);
      EXPECT_NEAR(noise.at(p), noise.at(p - Vec3(side, 2 * side, 0)), 1e-6);
    }
  }
}

TEST(PeriodicNoise, HasTheDeviationAndTheCorrelationOfTheOther) {
  const double side = 1, length = 0.03;
  double squares = 0, products = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const CorrelatedNoise noise(length, Random(seed, 1), {side});
    for (int i = 0; i < 100; ++i) {
      for (int j = 0; j < 100; ++j) {
        const Vec3 p(i * 0.01, j * 0.01, 0);
        squares += noise.at(p) * noise.at(p);
        products += noise.at(p) * noise.at(p + Vec3(length, 0, 0));
        ++count;
      }
    }
  }
  // Some 400 cells of the length and a half, four times: means of squares within some 5 %.
  EXPECT_NEAR(squares / count, 1, 0.1);
  EXPECT_NEAR(products / squares, std::exp(-1.0), 0.06);
}

TEST(TileNoise, RunsOnOverTheSidesOfItsSquare) {
  const TileNoise noise(3, 5, 8);
  const double last = 1 - 1e-9;
  for (int i = 0; i < 100; ++i) {
    const double s = i / 100.0;
    EXPECT_NEAR(noise.at({0, s}), noise.at({last, s}), 1e-4);
    EXPECT_NEAR(noise.at({s, 0}), noise.at({s, last}), 1e-4);
  }
}

}  // namespace
}  // namespace craze
