// Smooth random variation of the plane that repeats.
#pragma once

#include <cmath>
#include <cstdint>

#include "craze/base/random.h"
#include "craze/tensor.h"

namespace craze {

/// Value noise of several octaves, −1 … 1, in the unit square, which continues on itself: the first
/// has `cells` random values a side, each next one twice as many and 0.6 of the strength.
class TileNoise {
 public:
  TileNoise(std::uint64_t seed, std::int32_t cells, int octaves)
      : seed_(seed), cells_(cells), octaves_(octaves) {}

  /// u and v in [0, 1).
  double at(const Vec2& uv) const {
    double sum = 0, most = 0, strength = 1;
    std::int32_t cells = cells_;
    for (int octave = 0; octave < octaves_; ++octave) {
      sum += strength * octave_at(uv, cells, static_cast<std::uint64_t>(octave));
      most += strength;
      strength *= 0.6;
      cells *= 2;
    }
    return sum / most;
  }

 private:
  double octave_at(const Vec2& uv, std::int32_t cells, std::uint64_t octave) const {
    const double x = uv.x() * cells, y = uv.y() * cells;
    const auto i = static_cast<std::int32_t>(x), j = static_cast<std::int32_t>(y);
    const auto value = [&](std::int32_t a, std::int32_t b) {
      const auto cell = static_cast<std::uint64_t>(b % cells) * static_cast<std::uint64_t>(cells) +
                        static_cast<std::uint64_t>(a % cells);
      const std::uint64_t bits = hash_bits(seed_ ^ hash_bits(cell + (octave << 40)));
      return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
    };
    const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
    const double s = smooth(x - i), t = smooth(y - j);
    const double low = value(i, j) + s * (value(i + 1, j) - value(i, j));
    const double high = value(i, j + 1) + s * (value(i + 1, j + 1) - value(i, j + 1));
    return low + t * (high - low);
  }

  std::uint64_t seed_;
  std::int32_t cells_;
  int octaves_;
};

}  // namespace craze
