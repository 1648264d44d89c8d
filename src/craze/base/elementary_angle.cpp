// Angles and lengths of vectors in the plane.
#include <algorithm>
#include <cmath>
#include <limits>

#include "craze/base/double_double.h"
#include "craze/base/elementary.h"
#include "craze/base/polynomial.h"

namespace craze::elementary {

namespace {

constexpr DoubleDouble pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

// arctan(k / 8)
constexpr DoubleDouble arctan_of_eighths[] = {
    {0, 0},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

/// arctan(small / big) for 0 ≤ small ≤ big, 0 < big < ∞.
DoubleDouble first_octant(double small, double big) {
  // A ratio whose cube does not count.
  if (small < big * 0x1p-30) return {small / big, 0};
  if (big > 0x1p500 || big < 0x1p-500) {
    const double scale = big > 1 ? 0x1p-600 : 0x1p600;
    small *= scale, big *= scale;
  }
  // arctan q = arctan c + arctan t, t = (q − c) / (1 + q c), |t| ≤ 1/16.
  const int k = static_cast<int>(std::floor(8 * (small / big) + 0.5));
  const double c = 0.125 * k;
  const DoubleDouble down = two_product(c, big), across = two_product(c, small);
  DoubleDouble below = two_sum(big, across.high);
  below.low += across.low;
  const DoubleDouble t = quotient(two_sum(small - down.high, -down.low), below);
  const double z = t.high * t.high;
  constexpr double terms[] = {-1. / 3, 1. / 5, -1. / 7, 1. / 9, -1. / 11, 1. / 13, -1. / 15};
  const double tail = polynomial(z, terms);
  return sum(arctan_of_eighths[k], fast_two_sum(t.high, t.low + t.high * z * tail));
}

}  // namespace

double atan2(double y, double x) {
  if (x != x || y != y) return std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double right = std::fabs(x), up = std::fabs(y);
  if (right == infinity || up == infinity) {
    right = right == infinity ? 1 : 0;
    up = up == infinity ? 1 : 0;
  }
  DoubleDouble angle;
  if (right > 0 || up > 0) angle = first_octant(std::min(up, right), std::max(up, right));
  if (up > right) angle = sum(half_pi, {-angle.high, -angle.low});
  if (std::signbit(x)) angle = sum(pi, {-angle.high, -angle.low});
  return std::copysign(angle.high + angle.low, y);
}

double asin(double x) {
  if (!(std::fabs(x) <= 1)) return std::numeric_limits<double>::quiet_NaN();
  if (std::fabs(x) < 0x1p-27) return x;
  return atan2(x, std::sqrt((1 - x) * (1 + x)));
}

double hypot(double x, double y) {
  const double a = std::fabs(x), b = std::fabs(y);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (a == infinity || b == infinity) return infinity;
  if (a != a || b != b) return std::numeric_limits<double>::quiet_NaN();
  const double big = std::max(a, b), small = std::min(a, b);
  if (big > 0x1p500) {
    const double u = big * 0x1p-600, v = small * 0x1p-600;
    return std::sqrt(u * u + v * v) * 0x1p600;
  }
  if (big < 0x1p-450) {
    const double u = big * 0x1p600, v = small * 0x1p600;
    return std::sqrt(u * u + v * v) * 0x1p-600;
  }
  return std::sqrt(big * big + small * small);
}

}  // namespace craze::elementary
