#include "craze/products/faces/face_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/base/elementary.h"
#include "craze/base/random.h"

namespace craze {

namespace {

constexpr std::uint64_t stream = 0x66616365;  // "face"
/// Lengths of noise: the longest in depths, the shortest in steps; longer ones are slopes, which a
/// face that is tied to both its edges has not, shorter ones make up for those between points.
constexpr double longest = 4, shortest = 0.25;
constexpr int most_octaves = 16;

Random random_of(std::uint64_t seed, std::uint64_t octave) {
  return Random(hash_bits(seed), stream ^ hash_bits(octave));
}

/// Variance of the octave of length L, over L^{2 exponent}, for a mean square difference of
/// r^{2 exponent} over r = 1 from octaves of all lengths 2^k.
double unit_variance(double exponent) {
  constexpr int each_way = 64;
  double sum = 0;
  for (int k = -each_way; k <= each_way; ++k) {
    const double length = std::ldexp(1.0, k);
    const double apart = -std::ldexp(1.0, -2 * k);
    // 1 − eˣ, of small x without loss.
    const double part = apart > -1e-8 ? -apart : 1 - elementary::exp(apart);
    sum += 2 * elementary::pow(length, 2 * exponent) * part;
  }
  return 1 / sum;
}

}  // namespace

FaceField::FaceField(const FaceFieldOptions& options)
    : arc_(2 * options.depth, random_of(options.seed, most_octaves)),
      arc_height_(std::numbers::sqrt2 / std::numbers::pi * options.amplitude *
                  elementary::pow(options.depth / options.usual, options.exponent)) {
  const double scale = std::sqrt(unit_variance(options.exponent));
  double length = longest * options.depth;
  for (int k = 0; k < most_octaves && length > shortest * options.step; ++k, length /= 2) {
    octaves_.emplace_back(length, random_of(options.seed, static_cast<std::uint64_t>(k)));
    strengths_.push_back(scale * options.amplitude *
                         elementary::pow(length / options.usual, options.exponent));
  }
}

double FaceField::at(const Vec3& p, Memory& memory) const {
  memory.of_octave.resize(octaves_.size());
  double sum = 0;
  for (std::size_t k = 0; k < octaves_.size(); ++k) {
    sum += strengths_[k] * octaves_[k].at(p, memory.of_octave[k]);
  }
  return sum;
}

double FaceField::arc(const Vec3& p, Memory& memory) const {
  return arc_height_ * arc_.at(p, memory.of_arc);
}

}  // namespace craze
