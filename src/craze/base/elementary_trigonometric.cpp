// Sine, cosine and tangent.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "craze/base/double_double.h"
#include "craze/base/elementary.h"
#include "craze/base/polynomial.h"

namespace craze::elementary {

namespace {

/// x = n π/2 + rest, |rest| ≤ π/4 or hardly more; n modulo 4.
struct Reduced {
  int quadrant = 0;
  DoubleDouble rest;
};

// 2/π, 32 bits a word.
constexpr std::array<std::uint32_t, 39> two_per_pi = {
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20};

/// For x > 4096. Payne and Hanek: of the words of 2/π only those count whose product with x is not
/// a multiple of 4 and not too small to matter; 8 of them leave an error below 2⁻¹⁶⁰.
Reduced reduce_large(double x) {
  constexpr int words = 8;
  int exponent;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  exponent -= 53;  // x = mantissa 2^exponent
  const int first = exponent < 2 ? 0 : (exponent - 2) / 32;
  // The product, in limbs of 32 bits, the least first; times 2^(exponent − 32 (first + words)).
  std::array<std::uint64_t, words + 2> limbs{};
  for (const int part : {0, 1}) {
    const std::uint64_t factor = part == 0 ? mantissa & 0xffffffffu : mantissa >> 32;
    std::uint64_t carry = 0;
    for (int i = 0; i < words; ++i) {
      carry += limbs[i + part] + factor * two_per_pi[first + words - 1 - i];
      limbs[i + part] = carry & 0xffffffffu;
      carry >>= 32;
    }
    limbs[words + part] += carry;
  }
  // Bits from the weight 2 of the quadrant downwards.
  const int top = 32 * (first + words) - exponent + 1;
  const auto bits_from = [&](int bit) {  // 32 of them, the highest of which is `bit`
    std::uint64_t taken = 0;
    for (int limb = words + 1; limb >= 0; --limb) {
      const int shift = bit - 31 - 32 * limb;  // of the taken bits in this limb
      if (shift >= 32 || shift <= -32) continue;
      taken |= shift >= 0 ? limbs[limb] >> shift : limbs[limb] << -shift;
    }
    return taken & 0xffffffffu;
  };
  Reduced result;
  result.quadrant = static_cast<int>(bits_from(top) >> 30);
  // The fraction, from the smallest part; rounded up it is one less.
  const bool up = bits_from(top - 2) >> 31;
  DoubleDouble fraction;
  double weight = 0x1p-160;
  for (int i = 4; i >= 0; --i, weight *= 0x1p32) {
    std::uint64_t part = bits_from(top - 2 - 32 * i);
    if (up) part ^= 0xffffffffu;  // 1 − fraction, but for the last of 160 bits
    const DoubleDouble s = two_sum(weight * static_cast<double>(part), fraction.high);
    fraction = {s.high, s.low + fraction.low};
  }
  if (up) {
    fraction = {-fraction.high, -fraction.low};
    ++result.quadrant;
  }
  result.rest = product(fraction, half_pi);
  return result;
}

/// For finite x.
Reduced reduce(double x) {
  const double size = std::fabs(x);
  Reduced result;
  if (size <= 0.78539816339744831) {
    result.rest = {size, 0};
  } else if (size <= 4096) {
    // π/2 in parts of 40 bits, whose products with n are exact, and the rest.
    constexpr double part1 = 0x1.921fb54442p+0, part2 = 0x1.a308d31318p-41,
                     part3 = 0x1.8a2e03707344ap-81;
    const double n = std::floor(size * 0x1.45f306dc9c883p-1 + 0.5);
    const DoubleDouble rest = two_sum(size - n * part1, -n * part2);
    const DoubleDouble last = two_product(-n, part3);
    result.rest = sum(rest, last);
    result.quadrant = static_cast<int>(n);
  } else {
    result = reduce_large(size);
  }
  if (x < 0) {
    result.quadrant = -result.quadrant;
    result.rest = {-result.rest.high, -result.rest.low};
  }
  result.quadrant &= 3;
  return result;
}

/// By Taylor's series, for |x| ≤ π/4; the sum of the parts is not rounded.
DoubleDouble sin_near_zero(const DoubleDouble& x) {
  const double r = x.high, z = r * r;
  constexpr double terms[] = {
      -1. / 6,        1. / 120,        -1. / 5040,          1. / 362880,
      -1. / 39916800, 1. / 6227020800, -1. / 1307674368000, 1. / 355687428096000};
  const double tail = polynomial(z, terms);
  return fast_two_sum(r, r * z * tail + x.low * (1 - 0.5 * z));
}

DoubleDouble cos_near_zero(const DoubleDouble& x) {
  const double r = x.high, z = r * r;
  constexpr double terms[] = {
      1. / 24,        -1. / 720,         1. / 40320,          -1. / 3628800,
      1. / 479001600, -1. / 87178291200, 1. / 20922789888000, -1. / 6402373705728000};
  const double tail = polynomial(z, terms);
  const DoubleDouble head = fast_two_sum(1, -0.5 * z);
  return fast_two_sum(head.high, head.low + (z * z * tail - r * x.low));
}

}  // namespace

double sin(double x) {
  if (!std::isfinite(x)) return std::numeric_limits<double>::quiet_NaN();
  if (std::fabs(x) < 0x1p-27) return x;
  const Reduced a = reduce(x);
  const DoubleDouble size = a.quadrant % 2 == 0 ? sin_near_zero(a.rest) : cos_near_zero(a.rest);
  return a.quadrant < 2 ? size.high : -size.high;
}

double cos(double x) {
  if (!std::isfinite(x)) return std::numeric_limits<double>::quiet_NaN();
  const Reduced a = reduce(x);
  const DoubleDouble size = a.quadrant % 2 == 0 ? cos_near_zero(a.rest) : sin_near_zero(a.rest);
  return a.quadrant == 0 || a.quadrant == 3 ? size.high : -size.high;
}

double tan(double x) {
  if (!std::isfinite(x)) return std::numeric_limits<double>::quiet_NaN();
  if (std::fabs(x) < 0x1p-27) return x;
  const Reduced a = reduce(x);
  const DoubleDouble s = sin_near_zero(a.rest), c = cos_near_zero(a.rest);
  const DoubleDouble size = a.quadrant % 2 == 0 ? quotient(s, c) : quotient(c, s);
  return a.quadrant % 2 == 0 ? size.high + size.low : -(size.high + size.low);
}

}  // namespace craze::elementary
