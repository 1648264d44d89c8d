// Seeded random numbers, the same on every machine and in any order of evaluation.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "craze/base/elementary.h"

namespace craze {

/// Mixes a 64-bit word so that every input bit reaches every output bit (splitmix64's finaliser).
inline std::uint64_t hash_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// A stream of numbers named by a seed and a purpose. Draws in sequence with next(); at(i) draws
/// the i-th number of the stream whatever was drawn before, so parallel loops stay reproducible.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : key_(hash_bits(hash_bits(seed) ^ (stream * 0xd1342543de82ef95ull))) {}

  std::uint64_t at(std::uint64_t index) const { return hash_bits(key_ ^ hash_bits(index)); }
  std::uint64_t next() { return at(counter_++); }

  /// Uniform in [0, 1).
  double uniform() { return to_unit(next()); }
  double uniform_at(std::uint64_t index) const { return to_unit(at(index)); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 … n−1, n > 0.
  std::uint64_t below(std::uint64_t n) { return next() % n; }
  /// Mean 0, standard deviation 1 (Box–Muller).
  double normal() {
    const double u = uniform(), v = uniform();
    return box_muller(u, v);
  }
  double normal_at(std::uint64_t index) const {
    return box_muller(uniform_at(2 * index), uniform_at(2 * index + 1));
  }

 private:
  static double to_unit(std::uint64_t x) { return static_cast<double>(x >> 11) * 0x1.0p-53; }
  static double box_muller(double u, double v) {
    return std::sqrt(-2 * elementary::log(1 - u)) * elementary::cos(2 * std::numbers::pi * v);
  }

  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace craze
