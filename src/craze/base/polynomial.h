// Polynomials of one variable.
#pragma once

#include <cstddef>

namespace craze {

/// c[0] + c[1] z + c[2] z² + …, the even and the odd powers in two chains that run side by side.
template <std::size_t n>
double polynomial(double z, const double (&c)[n]) {
  static_assert(n >= 2);
  constexpr std::size_t last_even = (n - 1) / 2 * 2, last_odd = n / 2 * 2 - 1;
  const double w = z * z;
  double even = c[last_even], odd = c[last_odd];
  for (std::size_t i = last_even; i > 0; i -= 2) even = even * w + c[i - 2];
  for (std::size_t i = last_odd; i > 1; i -= 2) odd = odd * w + c[i - 2];
  return even + z * odd;
}

}  // namespace craze
