// Well-spread sample points, the same for a pixel whatever the order pixels are drawn in.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "craze/base/random.h"
#include "craze/render/color.h"

namespace craze::render {

struct Point2f {
  float x, y;  ///< in [0, 1)
};

/// The first two dimensions of Sobol's sequence, nested-uniform scrambled by a hash [Laine & Karras
/// 2011, "Stratified sampling for stochastic transparency", section 3.1]. One set per purpose.
class SampleSet {
 public:
  SampleSet(std::uint32_t pixel, std::uint32_t purpose)
      : seed_(static_cast<std::uint32_t>(hash_bits((std::uint64_t{purpose} << 32) | pixel))) {}

  Point2f operator[](std::uint32_t index) const {
    const std::uint32_t i = scramble(index, seed_);
    return {to_unit(scramble(reverse(i), seed_ ^ 0x68bc21ebu)),
            to_unit(scramble(second_dimension(i), seed_ ^ 0x02e5be93u))};
  }

 private:
  static std::uint32_t reverse(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
    x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
    return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
  }
  static std::uint32_t second_dimension(std::uint32_t i) {
    std::uint32_t x = 0;
    for (std::uint32_t v = 1u << 31; i; i >>= 1, v ^= v >> 1) {
      if (i & 1) x ^= v;
    }
    return x;
  }
  static std::uint32_t scramble(std::uint32_t x, std::uint32_t seed) {
    x = reverse(x) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverse(x);
  }
  static float to_unit(std::uint32_t x) { return static_cast<float>(x >> 8) * 0x1.0p-24f; }

  std::uint32_t seed_;
};

/// Two unit vectors that complete n (unit) to a right-handed frame.
inline void complete_frame(const Vec3f& n, Vec3f& s, Vec3f& t) {
  const float sign = std::copysign(1.0f, n.z()), a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
  s = {1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()};
  t = {b, sign + n.y() * n.y() * a, -n.y()};
}

/// A direction about n with density cosine / π.
inline Vec3f cosine_direction(const Vec3f& n, Point2f u) {
  Vec3f s, t;
  complete_frame(n, s, t);
  const float r = std::sqrt(u.x), phi = 2 * std::numbers::pi_v<float> * u.y;
  return (r * std::cos(phi) * s + r * std::sin(phi) * t + std::sqrt(1 - u.x) * n).normalized();
}

/// A direction uniform in a narrow cone about the unit vector `axis`.
inline Vec3f cone_direction(const Vec3f& axis, float tan_half_angle, Point2f u) {
  Vec3f s, t;
  complete_frame(axis, s, t);
  const float r = tan_half_angle * std::sqrt(u.x), phi = 2 * std::numbers::pi_v<float> * u.y;
  return (axis + r * std::cos(phi) * s + r * std::sin(phi) * t).normalized();
}

}  // namespace craze::render
