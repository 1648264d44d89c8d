// Exponential, logarithm and power.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "craze/base/double_double.h"
#include "craze/base/elementary.h"
#include "craze/base/polynomial.h"

namespace craze::elementary {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// ln 2: 42 bits, whose product with an exponent is exact, and the rest.
constexpr double ln2_high = 0x1.62e42fefa3800p-1, ln2_low = 0x1.ef35793c76730p-45;
constexpr double per_ln2 = 0x1.71547652b82fep+0;

/// 2ᵏ, −1022 ≤ k ≤ 1023.
double power_of_two(int k) {
  const auto bits = static_cast<std::uint64_t>(k + 1023) << 52;
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// x 2ᵏ, −1100 < k ≤ 1024, rounded once.
double scaled(double x, int k) {
  if (k > 1023) return x * 0x1p1023 * power_of_two(k - 1023);
  if (k < -1021) return x * power_of_two(k + 1000) * 0x1p-1000;
  return x * power_of_two(k);
}

/// eˣ for |x| < 1000.
double exp_of(const DoubleDouble& x) {
  // x = k ln 2 + r, |r| ≤ ln 2 / 2.
  const double k = std::floor(x.high * per_ln2 + 0.5);
  const DoubleDouble r = two_sum(x.high - k * ln2_high, x.low - k * ln2_low);
  // eʳ − 1 − r, by Taylor's series.
  constexpr double inverse_factorials[] = {
      1. / 2,     1. / 6,      1. / 24,      1. / 120,      1. / 720,       1. / 5040,
      1. / 40320, 1. / 362880, 1. / 3628800, 1. / 39916800, 1. / 479001600, 1. / 6227020800};
  const double tail = r.high * r.high * polynomial(r.high, inverse_factorials);
  const DoubleDouble head = fast_two_sum(1, r.high);
  const double power = head.high + (head.low + (tail + (r.low + r.low * r.high)));
  return scaled(power, static_cast<int>(k));
}

/// x = 2ᵏ (1 + f), √½ ≤ 1 + f < √2, for finite x > 0.
struct Split {
  double k, f;
};

Split split(double x) {
  int exponent;
  const double half = std::frexp(x, &exponent);
  if (half < 0.70710678118654752) return {exponent - 1.0, 2 * half - 1};
  return {static_cast<double>(exponent), half - 1};
}

/// 1/5 + z/7 + z²/9 + …, for z < 0.0295: of artanh s = s + s z (1/3 + z (1/5 + …)), z = s².
double artanh_tail(double z) {
  constexpr double inverse_odds[] = {1. / 5,  1. / 7,  1. / 9,  1. / 11, 1. / 13, 1. / 15,
                                     1. / 17, 1. / 19, 1. / 21, 1. / 23, 1. / 25};
  return polynomial(z, inverse_odds);
}

/// ln x for finite x > 0, to about 2⁻⁶⁴ of it.
DoubleDouble log_of(double x) {
  // ln (1 + f) = 2 artanh s, s = f / (2 + f), |s| < 0.172.
  const auto [k, f] = split(x);
  const DoubleDouble d = two_sum(2, f);
  const double s_high = f / d.high;
  const DoubleDouble back = two_product(s_high, d.high);
  const DoubleDouble s{s_high, ((f - back.high) - back.low - s_high * d.low) / d.high};
  const DoubleDouble z = product(s, s);
  constexpr DoubleDouble third{1. / 3, 0x1.5555555555555p-56};
  const DoubleDouble series = sum(third, {z.high * artanh_tail(z.high), 0});
  const DoubleDouble artanh = sum(s, product(s, product(z, series)));
  return sum({k * ln2_high, k * ln2_low}, {2 * artanh.high, 2 * artanh.low});
}

bool is_integer(double x) {
  return std::floor(x) == x;
}
bool is_odd(double x) {
  return is_integer(x) && std::fmod(x, 2) != 0;
}

}  // namespace

double exp(double x) {
  if (!(x < 709.79)) return x > 0 ? infinity : x;  // NaN stays
  if (x < -745.2) return 0;
  return exp_of({x, 0});
}

double log(double x) {
  if (!(x > 0)) return x == 0 ? -infinity : nan;
  if (x == infinity) return infinity;
  // ln (1 + f) = f − f²/2 + s (f²/2 + 2 artanh s / s − 2): what is rounded is small beside f.
  const auto [k, f] = split(x);
  const double s = f / (2 + f), z = s * s, half = 0.5 * f * f;
  const double rest = 2 * z * (1. / 3 + z * artanh_tail(z));
  return k * ln2_high + (f - (half - (s * (half + rest) + k * ln2_low)));
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (x != x || y != y) return nan;
  const double size = std::fabs(x);
  if (std::fabs(y) == infinity) {
    if (size == 1) return 1;
    return (size > 1) == (y > 0) ? infinity : 0;
  }
  const double sign = std::signbit(x) && is_odd(y) ? -1 : 1;
  if (size == 0 || size == infinity) return (size == 0) == (y < 0) ? sign * infinity : sign * 0.0;
  if (x < 0 && !is_integer(y)) return nan;
  const DoubleDouble logarithm = log_of(size);
  const double about = y * logarithm.high;
  if (about > 710) return sign * infinity;
  if (about < -746) return sign * 0.0;
  if (std::fabs(about) < 0x1p-60) return sign;
  const double power = exp_of(product({y, 0}, logarithm));
  return sign * power;
}

}  // namespace craze::elementary
