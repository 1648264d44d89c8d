// Numbers of twice the precision, as sums of two: how elementary functions round well.
#pragma once

namespace craze {

/// high + low, where low is at most about half a last place of high.
struct DoubleDouble {
  double high = 0, low = 0;
};

namespace elementary {
inline constexpr DoubleDouble half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
}

/// a + b exactly.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double from_b = sum - a;
  return {sum, (a - (sum - from_b)) + (b - from_b)};
}

/// a + b exactly, where |a| ≥ |b| or a = 0.
inline DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a b exactly, by Dekker's halves: the product is at least 1e-290 or 0, factors at most 1e290.
inline DoubleDouble two_product(double a, double b) {
  constexpr double halves = 0x1p27 + 1;
  const double ga = halves * a, gb = halves * b;
  const double ah = ga - (ga - a), bh = gb - (gb - b);
  const double al = a - ah, bl = b - bh;
  const double product = a * b;
  return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
}

/// a b to about 2⁻¹⁰⁰ of it, in the range of two_product().
inline DoubleDouble product(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble p = two_product(a.high, b.high);
  return fast_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// a + b to about 2⁻¹⁰⁰ of the larger.
inline DoubleDouble sum(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble s = two_sum(a.high, b.high);
  return fast_two_sum(s.high, s.low + (a.low + b.low));
}

/// a / b to about 2⁻¹⁰⁰ of it, in the range of two_product().
inline DoubleDouble quotient(const DoubleDouble& a, const DoubleDouble& b) {
  const double about = a.high / b.high;
  const DoubleDouble back = two_product(about, b.high);
  return {about, (((a.high - back.high) - back.low) + (a.low - about * b.low)) / b.high};
}

}  // namespace craze
