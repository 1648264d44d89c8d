// Smooth random variation in space, for the look of real materials.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "craze/base/random.h"
#include "craze/render/material/color.h"

namespace craze::render {

/// A value in −1 … 1 and how it changes along the axes.
struct Noise {
  float value = 0;
  Vec3f gradient = Vec3f::Zero();
};

/// Value noise with one random value per unit cube, smooth between them.
inline Noise value_noise(const Vec3f& p) {
  const Vec3f cell(std::floor(p.x()), std::floor(p.y()), std::floor(p.z()));
  const Vec3f f = p - cell;
  const Vec3f w = (f.array() * f.array() * (3 - 2 * f.array())).matrix();
  const Vec3f dw = (6 * f.array() * (1 - f.array())).matrix();
  const auto part = [](float x, int i, std::uint64_t prime) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(x) + i) * prime;
  };
  float value[2][2][2];
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      for (int k = 0; k < 2; ++k) {
        const std::uint64_t h = hash_bits(part(cell.x(), i, 0x9e3779b97f4a7c15ull) ^
                                          part(cell.y(), j, 0xc2b2ae3d27d4eb4full) ^
                                          part(cell.z(), k, 0x165667b19e3779f9ull));
        value[i][j][k] = static_cast<float>(h >> 40) * 0x1.0p-23f - 1;
      }
    }
  }
  const auto mix = [](float a, float b, float t) { return a + t * (b - a); };
  // Along x, then y, then z; the slope along an axis is what the mix along it goes through.
  float along_x[2][2], slope_x[2][2];
  for (int j = 0; j < 2; ++j) {
    for (int k = 0; k < 2; ++k) {
      along_x[j][k] = mix(value[0][j][k], value[1][j][k], w.x());
      slope_x[j][k] = value[1][j][k] - value[0][j][k];
    }
  }
  const float low = mix(along_x[0][0], along_x[1][0], w.y());
  const float high = mix(along_x[0][1], along_x[1][1], w.y());
  Noise noise;
  noise.value = mix(low, high, w.z());
  noise.gradient = {
      dw.x() * mix(mix(slope_x[0][0], slope_x[1][0], w.y()),
                   mix(slope_x[0][1], slope_x[1][1], w.y()), w.z()),
      dw.y() * mix(along_x[1][0] - along_x[0][0], along_x[1][1] - along_x[0][1], w.z()),
      dw.z() * (high - low)};
  return noise;
}

/// The nearest of points strewn in space, one in each unit cube.
struct Cell {
  float first = 0, second = 0;  ///< distances to the nearest point and to the next
  std::uint64_t id = 0;         ///< of the nearest
};

inline Cell nearest_cell(const Vec3f& p) {
  const Vec3f corner(std::floor(p.x()), std::floor(p.y()), std::floor(p.z()));
  Cell cell{8, 8, 0};
  for (int k = 0; k < 27; ++k) {
    const Vec3f cube =
        corner + Vec3f(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 % 3 - 1),
                       static_cast<float>(k / 9 - 1));
    const auto part = [](float x, std::uint64_t prime) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)) * prime;
    };
    const std::uint64_t id =
        hash_bits(part(cube.x(), 0x9e3779b97f4a7c15ull) ^ part(cube.y(), 0xc2b2ae3d27d4eb4full) ^
                  part(cube.z(), 0x165667b19e3779f9ull));
    const Random random(id);
    Vec3f point = cube;
    for (int i = 0; i < 3; ++i) point[i] += static_cast<float>(random.uniform_at(i));
    const float distance = (point - p).norm();
    if (distance < cell.first) {
      cell = {distance, cell.first, id};
    } else {
      cell.second = std::min(cell.second, distance);
    }
  }
  return cell;
}

/// Octaves of value noise, each half as strong and twice as fine; about −1 … 1.
inline Noise fractal_noise(const Vec3f& p, int octaves = 4) {
  Noise sum;
  float strength = 0.55f, scale = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    // Each octave is displaced, so that the lattices do not line up.
    const auto shift = Vec3f::Constant(17.3f * static_cast<float>(octave));
    const Noise one = value_noise(scale * p + shift);
    sum.value += strength * one.value;
    sum.gradient += strength * scale * one.gradient;
    strength *= 0.5f;
    scale *= 2.03f;
  }
  return sum;
}

}  // namespace craze::render
