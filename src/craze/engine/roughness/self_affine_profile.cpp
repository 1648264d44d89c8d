#include "craze/engine/roughness/self_affine_profile.h"

#include <cassert>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>

#include "craze/base/elementary.h"

namespace craze {

namespace {

using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double first_edge = 1.5;    // waves below are one arc
constexpr double known_lag = 0x1p-4;  // where the profile is scaled, of the length

/// Σ a[n] e^{2πi jn/N} in place, N a power of two (Cooley–Tukey).
void transform(std::vector<Complex>& a) {
  const std::size_t n = a.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; (j & bit) != 0; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(a[i], a[j]);
  }
  std::vector<Complex> root(n / 2);
  for (std::size_t i = 0; i < n / 2; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
    root[i] = {elementary::cos(angle), elementary::sin(angle)};
  }
  for (std::size_t half = 1; half < n; half *= 2) {
    for (std::size_t i = 0; i < n; i += 2 * half) {
      for (std::size_t j = 0; j < half; ++j) {
        const Complex r = root[j * (n / 2 / half)], b = a[i + j + half];
        const Complex turned(b.real() * r.real() - b.imag() * r.imag(),
                             b.real() * r.imag() + b.imag() * r.real());
        a[i + j + half] = a[i + j] - turned;
        a[i + j] += turned;
      }
    }
  }
}

/// Of the waves sin(πk x), k = 1 …, up to a common factor: the variances of their amplitudes. The
/// first stands for all slower ones and has the mean square slope that they had together.
class Spectrum {
 public:
  explicit Spectrum(double exponent) : power_(-1 - 2 * exponent) {
    arc_ = elementary::pow(first_edge, 2 - 2 * exponent) / (2 - 2 * exponent);
  }

  double at(double k) const { return k > 1 ? elementary::pow(k, power_) : arc_; }
  /// Of wave k as points at 1/n see it: with those finer that look alike.
  double seen(double k, double n) const {
    const double finest = elementary::pow(3 * n, power_ + 1) / (-1 - power_) / n;  // an integral
    return at(k) + elementary::pow(2 * n - k, power_) + elementary::pow(2 * n + k, power_) + finest;
  }

 private:
  double power_, arc_;
};

/// The mean square difference over `lag`.
double structure(const Spectrum& spectrum, double exponent, double lag) {
  constexpr int waves = 512;
  double sum = 0;
  for (int k = 1; k <= waves; ++k) sum += spectrum.at(k) * (1 - elementary::cos(pi * k * lag));
  return sum + elementary::pow(waves + 0.5, -2 * exponent) / (2 * exponent);
}

}  // namespace

std::vector<double> self_affine_profile(int k, double exponent, const Random& random) {
  assert(k >= 1 && k <= 20 && exponent > 0 && exponent < 1);
  const std::size_t n = std::size_t{1} << static_cast<unsigned>(k);
  const Spectrum spectrum(exponent);
  const double scale = std::sqrt(elementary::pow(known_lag, 2 * exponent) /
                                 structure(spectrum, exponent, known_lag));
  std::vector<Complex> waves(2 * n);
  for (std::size_t w = 1; w < n; ++w) {
    const double variance = spectrum.seen(static_cast<double>(w), static_cast<double>(n));
    waves[w] = scale * std::sqrt(variance) * random.normal_at(w);
  }
  transform(waves);
  std::vector<double> heights(n + 1, 0.0);
  for (std::size_t i = 1; i < n; ++i) heights[i] = waves[i].imag();
  return heights;
}

}  // namespace craze
