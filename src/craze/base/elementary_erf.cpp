// The error function.
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "craze/base/elementary.h"

namespace craze::elementary {

namespace {

// erf(k / 8)
constexpr double erf_of_eighths[] = {0x0.0p+0,
                                     0x1.1f5e1a35c3b89p-3,
                                     0x1.1af54e232d609p-2,
                                     0x1.9dd0d2b721f39p-2,
                                     0x1.0a7ef5c18edd2p-1,
                                     0x1.3f196dcd0f135p-1,
                                     0x1.6c1c9759d0e5fp-1,
                                     0x1.91724951b8fc6p-1,
                                     0x1.af767a741088bp-1,
                                     0x1.c6dad2829ec62p-1,
                                     0x1.d8865d98abe01p-1,
                                     0x1.e5768c3b4a3fcp-1,
                                     0x1.eea5557137ae0p-1,
                                     0x1.f4f693b67bd77p-1,
                                     0x1.f92d077f8d56dp-1,
                                     0x1.fbe61eef4cf6ap-1,
                                     0x1.fd9ae142795e3p-1,
                                     0x1.fea4218d6594ap-1,
                                     0x1.ff404760319b4p-1,
                                     0x1.ff9960f3eb327p-1,
                                     0x1.ffcaa8f4c9beap-1,
                                     0x1.ffe514bbdc197p-1,
                                     0x1.fff2cfb0453d9p-1,
                                     0x1.fff9ba420e834p-1,
                                     0x1.fffd1ac4135f9p-1,
                                     0x1.fffeb3ebb267bp-1,
                                     0x1.ffff6f9f67e55p-1,
                                     0x1.ffffc316d9ed0p-1,
                                     0x1.ffffe710d565ep-1,
                                     0x1.fffff618c3da6p-1,
                                     0x1.fffffc2f171e3p-1,
                                     0x1.fffffe92ced93p-1,
                                     0x1.ffffff7b91176p-1,
                                     0x1.ffffffd169d0cp-1,
                                     0x1.fffffff01a8b6p-1,
                                     0x1.fffffffabd229p-1,
                                     0x1.fffffffe4fa30p-1,
                                     0x1.ffffffff79626p-1,
                                     0x1.ffffffffd759dp-1,
                                     0x1.fffffffff4188p-1,
                                     0x1.fffffffffc9e8p-1,
                                     0x1.ffffffffff11ap-1,
                                     0x1.ffffffffffc05p-1,
                                     0x1.ffffffffffef8p-1,
                                     0x1.fffffffffffbep-1,
                                     0x1.ffffffffffff0p-1,
                                     0x1.ffffffffffffcp-1,
                                     0x1.fffffffffffffp-1};

// 2/√π exp(−(k / 8)²), the slope there, as exp() gives it
constexpr double slope_of_eighths[] = {
    0x1.20dd750429b6dp+0,  0x1.1c62fa1e869b6p+0,  0x1.0f5d1602f7e41p+0,  0x1.f5f0cdaf15313p-1,
    0x1.c1efca49a5011p-1,  0x1.86e9694134b9ep-1,  0x1.492e42d78d2c5p-1,  0x1.0cab61f084b93p-1,
    0x1.a911f096fbc26p-2,  0x1.45e99bcbb7915p-2,  0x1.e4652fadcb6b1p-3,  0x1.5ce595c455b0ap-3,
    0x1.e723726b824a8p-4,  0x1.499d478bca735p-4,  0x1.b055303221015p-5,  0x1.12ceb37ff9bc3p-5,
    0x1.529b9e8cf9a1ep-6,  0x1.94624e78e0faep-7,  0x1.d4143a9dfe965p-8,  0x1.06918b6355624p-8,
    0x1.1d83170fbf6fcp-9,  0x1.2ce898809244ep-10, 0x1.3360ccd23db3ap-11, 0x1.30538fbb77ecdp-12,
    0x1.2408e9ba3327fp-13, 0x1.0f9e1b4dd36dfp-14, 0x1.e9b5e8d00ce76p-16, 0x1.abe09e9144b5ep-17,
    0x1.6a597219a93d9p-18, 0x1.296a70f414053p-19, 0x1.d9371e2ff7c35p-21, 0x1.6ce1aa3fd7bdcp-22,
    0x1.10b1488aeb235p-23, 0x1.8b0cfce0579ep-25,  0x1.155a09065d4f7p-26, 0x1.7974e743dea3dp-28,
    0x1.f1e3523b41d7dp-30, 0x1.3e44e45301b92p-31, 0x1.8a61745ec7d1dp-33, 0x1.d9a880f306bd8p-35,
    0x1.13af4f04f9998p-36, 0x1.370ab8327af5ep-38, 0x1.5422ef5d8949dp-40, 0x1.68823e52970bep-42,
    0x1.7258610b3b233p-44, 0x1.70beaf9c7ffb6p-46, 0x1.63daf8b4b1e0cp-48, 0x1.4cd9c04158cd7p-50};

constexpr std::size_t centres = std::size(erf_of_eighths), terms = 14;
static_assert(std::size(slope_of_eighths) == centres);
constexpr double inverses[] = {1.,     1. / 2,  1. / 3,  1. / 4,  1. / 5,  1. / 6,  1. / 7, 1. / 8,
                               1. / 9, 1. / 10, 1. / 11, 1. / 12, 1. / 13, 1. / 14, 1. / 15};
static_assert(std::size(inverses) == terms + 1);

using Series = std::array<double, terms>;

/// a₁ to a₁₄ for each c = k / 8. Taylor's series about c: exp(−(c+h)²) = exp(−c²) Σ aₙ hⁿ with
/// aₙ₊₁ = −2 (c aₙ + aₙ₋₁) / (n + 1).
constexpr std::array<Series, centres> taylor_series() {
  std::array<Series, centres> series{};
  for (std::size_t k = 0; k < centres; ++k) {
    const double c = 0.125 * static_cast<double>(k);
    double before = 0, a = 1;
    for (std::size_t n = 1; n <= terms; ++n) {
      const double next = -2 * (c * a + before) * inverses[n - 1];
      before = a, a = next;
      series[k][n - 1] = a;
    }
  }
  return series;
}
constexpr std::array<Series, centres> series_of_eighths = taylor_series();

}  // namespace

double erf(double x) {
  if (x != x) return x;
  const double size = std::fabs(x);
  if (size >= 5.9375) return std::copysign(1.0, x);
  const int k = static_cast<int>(8 * size + 0.5);
  const double h = size - 0.125 * k, slope = slope_of_eighths[k];
  // The series, integrated term by term.
  const Series& a = series_of_eighths[k];
  double power = h, tail = 0;
  for (std::size_t n = 1; n <= terms; ++n) {
    tail += a[n - 1] * power * inverses[n];
    power *= h;
  }
  return std::copysign(erf_of_eighths[k] + (slope * h + slope * h * tail), x);
}

}  // namespace craze::elementary
