#include "craze/model/failure/healed_cracks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "craze/base/random.h"

namespace craze {
namespace {

constexpr double ratio = 0.4, width = 0.1;

/// A straight crack along x in the plane, of many pieces.
std::vector<HealedPiece> straight_crack() {
  std::vector<HealedPiece> pieces;
  for (int i = 0; i < 40; ++i) {
    pieces.push_back({Vec3(0.05 * i - 1, 0, 0), Vec3(0.05 * i - 0.95, 0, 0), Vec3::UnitZ()});
  }
  return pieces;
}

/// The factor on the strength across a plane, as the header defines it.
double factor(const HealedCracks& healed, const Vec3& position, const Vec3& normal) {
  const Mat3 inverse = healed.weakness(position).inverse();
  return (inverse * normal).squaredNorm();
}

TEST(HealedCracks, AreAsWeakAsTheLayerWasAndTheRestIsStronger) {
  const HealedCracks healed(straight_crack(), ratio, width);
  EXPECT_NEAR(factor(healed, Vec3::Zero(), Vec3::UnitY()), 1, 1e-9);
  EXPECT_NEAR(factor(healed, Vec3::Zero(), Vec3::UnitX()), 1 / ratio, 1e-9);
  EXPECT_NEAR(factor(healed, Vec3(0, 1, 0), Vec3::UnitY()), 1 / ratio, 1e-9);
}

TEST(HealedCracks, AreWeakOverTheirWidthWhateverTheirPiecesLength) {
  const std::vector<HealedPiece> one = {{Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3::UnitZ()}};
  const HealedCracks coarse(one, ratio, width), fine(straight_crack(), ratio, width);
  for (double y = 0; y < 0.3; y += 0.05) {
    const Vec3 p(0.01, y, 0);
    EXPECT_LT((coarse.weakness(p) - fine.weakness(p)).norm(), 2e-2) << y;
    const double along = fine.weakness(p)(1, 1);
    const double law = std::exp(-y * y / (2 * width * width));
    EXPECT_NEAR(along, std::sqrt(ratio) + (1 - std::sqrt(ratio)) * law, 2e-2) << y;
  }
}

TEST(HealedCracks, TheWeakestPlaneIsTheBestOfAllPlanes) {
  const HealedCracks healed(straight_crack(), ratio, width);
  const Sym3 stress{1.0, 0.7, 0, 0.2, 0, 0};
  const Vec3 position(0.1, 0.05, 0);
  const WeakPlane weak = healed.weakest_plane(healed.weakness(position), stress);
  EXPECT_NEAR(weak.strength, factor(healed, position, weak.plane.vector), 1e-9);
  double best = 0;
  for (int i = 0; i < 3600; ++i) {
    const double angle = std::numbers::pi * i / 3600;
    const Vec3 normal(std::cos(angle), std::sin(angle), 0);
    best = std::max(best, normal.dot(stress * normal) / factor(healed, position, normal));
  }
  EXPECT_NEAR(weak.plane.value / weak.strength, best, 1e-5);
}

TEST(HealedCracks, AChangeOfStressCountsNoMoreThanTheSensitivity) {
  const HealedCracks healed(straight_crack(), ratio, width);
  Random random(3, 1);
  for (int i = 0; i < 50; ++i) {
    const Vec3 position(random.uniform(), 0.2 * random.uniform(), 0);
    const Sym3 stress{random.uniform(), random.uniform(), 0, random.uniform(), 0, 0};
    Sym3 more = stress;
    const double change = 0.3 * random.uniform();
    add_outer(more, change, Vec3(random.uniform(), random.uniform(), 0).normalized());
    const WeakPlane before = healed.weakest_plane(healed.weakness(position), stress);
    const WeakPlane after = healed.weakest_plane(healed.weakness(position), more);
    const double grown = after.plane.value / after.strength - before.plane.value / before.strength;
    // before.sensitivity is per strength of the plane before.
    EXPECT_LE(grown, before.sensitivity / before.strength * change + 1e-12);
  }
}

}  // namespace
}  // namespace craze
