#include "craze/render/rays/sampling.h"

#include <cmath>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/base/random.h"

namespace craze::render {

namespace {

std::uint32_t reverse(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
  x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
  return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

std::uint32_t second_dimension(std::uint32_t i) {
  std::uint32_t x = 0;
  for (std::uint32_t v = 1u << 31; i; i >>= 1, v ^= v >> 1) {
    if (i & 1) x ^= v;
  }
  return x;
}

std::uint32_t scramble(std::uint32_t x, std::uint32_t seed) {
  x = reverse(x) + seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return reverse(x);
}

float to_unit(std::uint32_t x) {
  return static_cast<float>(x >> 8) * 0x1.0p-24f;
}

/// From −1 to 1, denser in the middle: a tent filter, inverted.
float tent(float u) {
  return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u);
}

Point2f on_disc(Point2f u) {
  const float r = std::sqrt(u.x), phi = 2 * std::numbers::pi_v<float> * u.y;
  return {static_cast<float>(r * elementary::cos(phi)),
          static_cast<float>(r * elementary::sin(phi))};
}

}  // namespace

Point2f sobol_point(std::uint32_t index, std::uint32_t seed) {
  const std::uint32_t i = scramble(index, seed);
  return {to_unit(scramble(reverse(i), seed ^ 0x68bc21ebu)),
          to_unit(scramble(second_dimension(i), seed ^ 0x02e5be93u))};
}

SampleTable::SampleTable(int count, std::uint64_t seed)
    : count_(static_cast<std::size_t>(count)), seed_(seed) {
  lens_.reserve(sets * count_);
  disc_.reserve(sets * count_);
  aperture_.reserve(sets * count_);
  for (std::uint32_t set = 0; set < sets; ++set) {
    const auto key = static_cast<std::uint32_t>(hash_bits(seed ^ hash_bits(set)));
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
      const Point2f u = sobol_point(i, key);
      lens_.push_back({tent(u.x), tent(u.y)});
      disc_.push_back(on_disc(sobol_point(i, key ^ 0x5bd1e995u)));
      aperture_.push_back(on_disc(sobol_point(i, key ^ 0x27d4eb2fu)));
    }
  }
}

PixelSamples SampleTable::of_pixel(std::uint64_t pixel) const {
  const std::uint64_t h = hash_bits(seed_ ^ hash_bits(pixel));
  // The lamp and the sky take different sets.
  const std::uint64_t lens = h % sets, lamp = (h >> 16) % sets;
  const std::uint64_t sky = (lamp + 1 + (h >> 32) % (sets - 1)) % sets;
  return {&lens_[lens * count_], &disc_[lamp * count_], &disc_[sky * count_],
          &aperture_[lens * count_]};
}

void complete_frame(const Vec3f& n, Vec3f& s, Vec3f& t) {
  const float sign = std::copysign(1.0f, n.z()), a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
  s = {1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()};
  t = {b, sign + n.y() * n.y() * a, -n.y()};
}

Vec3f cosine_direction(const Vec3f& n, Point2f on_disc) {
  Vec3f s, t;
  complete_frame(n, s, t);
  const float squared = on_disc.x * on_disc.x + on_disc.y * on_disc.y;
  return on_disc.x * s + on_disc.y * t + std::sqrt(std::max(0.0f, 1 - squared)) * n;
}

Vec3f cone_direction(const Vec3f& axis, float tan_half_angle, Point2f on_disc) {
  Vec3f s, t;
  complete_frame(axis, s, t);
  return (axis + tan_half_angle * (on_disc.x * s + on_disc.y * t)).normalized();
}

}  // namespace craze::render
