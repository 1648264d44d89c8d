// Smooth random variation in space, for the look of real materials.
#pragma once

#include <cmath>
#include <cstdint>

#include "craze/base/random.h"
#include "craze/render/color.h"

namespace craze::render {

/// Value noise in −1 … 1 with one random value per unit cube, smooth between them.
inline float value_noise(const Vec3f& p) {
  const Vec3f cell(std::floor(p.x()), std::floor(p.y()), std::floor(p.z()));
  const Vec3f f = p - cell;
  const Vec3f w = (f.array() * f.array() * (3 - 2 * f.array())).matrix();
  const auto value = [&](int i, int j, int k) {
    const auto x = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.x()) + i);
    const auto y = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.y()) + j);
    const auto z = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.z()) + k);
    const std::uint64_t h = hash_bits(x * 0x9e3779b97f4a7c15ull ^ y * 0xc2b2ae3d27d4eb4full ^
                                      z * 0x165667b19e3779f9ull);
    return static_cast<float>(h >> 40) * 0x1.0p-23f - 1;
  };
  const auto mix = [](float a, float b, float t) { return a + t * (b - a); };
  const auto row = [&](int j, int k) { return mix(value(0, j, k), value(1, j, k), w.x()); };
  return mix(mix(row(0, 0), row(1, 0), w.y()), mix(row(0, 1), row(1, 1), w.y()), w.z());
}

/// Four octaves of value noise, each half as strong and twice as fine; about −1 … 1.
inline float fractal_noise(const Vec3f& p) {
  float sum = 0, strength = 0.55f, scale = 1;
  for (int octave = 0; octave < 4; ++octave) {
    // Each octave is displaced, so that the lattices do not line up.
    sum += strength * value_noise(scale * p + Vec3f::Constant(17.3f * octave));
    strength *= 0.5f;
    scale *= 2.03f;
  }
  return sum;
}

}  // namespace craze::render
