#include "craze/base/elementary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "craze/base/random.h"

namespace craze::elementary {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr int samples = 100000;

double from_bits(std::uint64_t bits) {
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// Any finite number, all exponents alike.
double any(Random& random) {
  for (;;) {
    const double x = from_bits(random.next());
    if (std::isfinite(x)) return x;
  }
}

/// How far `got` lies from `exact`, in units of the last place of the latter.
double error(double got, long double exact) {
  const auto rounded = static_cast<double>(exact);
  if (std::isnan(rounded) || std::isinf(rounded) || !std::isfinite(got)) {
    return got == rounded || (std::isnan(got) && std::isnan(rounded)) ? 0 : infinity;
  }
  int exponent = -1021;
  if (rounded != 0) std::frexp(rounded, &exponent);
  const long double unit = std::ldexp(1.0L, std::max(exponent, -1021) - 53);
  return static_cast<double>(std::fabs(got - exact) / unit);
}

/// Expects the functions of one number to agree within `units` over what `draw` gives.
template <class Function, class Reference, class Draw>
void expect_within(double units, const Function& function, const Reference& reference,
                   const Draw& draw) {
  Random random(1);
  double worst = 0, where = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = draw(random);
    const double e = error(function(x), reference(static_cast<long double>(x)));
    if (!(e <= worst)) worst = e, where = x;
  }
  EXPECT_LE(worst, units) << "at " << where;
}

template <class Function, class Reference, class Draw>
void expect_within_of_two(double units, const Function& function, const Reference& reference,
                          const Draw& draw) {
  Random random(2);
  double worst = 0;
  std::pair<double, double> where;
  for (int i = 0; i < samples; ++i) {
    const std::pair<double, double> p = draw(random);
    const auto exact =
        reference(static_cast<long double>(p.first), static_cast<long double>(p.second));
    const double e = error(function(p.first, p.second), exact);
    if (!(e <= worst)) worst = e, where = p;
  }
  EXPECT_LE(worst, units) << "at " << where.first << ", " << where.second;
}

auto between(double low, double high) {
  return [=](Random& random) { return random.uniform(low, high); };
}

/// Against the library's functions of a wider type.
class Elementary : public testing::Test {
 protected:
  void SetUp() override {
    if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "no wider type here";
  }
};

TEST_F(Elementary, ExponentialAndLogarithmAreWithinOneUnit) {
  const auto exponential = [](long double x) { return std::exp(x); };
  expect_within(1, exp, exponential, between(-746, 710));
  expect_within(1, exp, exponential, between(-1, 1));
  const auto logarithm = [](long double x) { return std::log(x); };
  expect_within(1, log, logarithm, [](Random& random) { return std::fabs(any(random)); });
  expect_within(1, log, logarithm, between(0.5, 2));
  expect_within(1, log, logarithm, between(1 - 1e-6, 1 + 1e-6));
}

TEST_F(Elementary, PowerIsWithinOneUnit) {
  const auto power = [](long double x, long double y) { return std::pow(x, y); };
  expect_within_of_two(1, pow, power, [](Random& random) {
    const double x = std::fabs(any(random));
    return std::pair(x, random.uniform(-1.1, 1.1));
  });
  expect_within_of_two(1, pow, power, [](Random& random) {
    const double x = random.uniform(0, 3);
    return std::pair(x, random.uniform(-600, 600));
  });
  expect_within_of_two(1, pow, power, [](Random& random) {
    const double x = random.uniform(-9, 0);
    return std::pair(x, std::floor(random.uniform(-300, 300)));
  });
}

TEST_F(Elementary, SineAndCosineAreWithinOneUnitHoweverLargeTheAngle) {
  const auto sine = [](long double x) { return std::sin(x); };
  const auto cosine = [](long double x) { return std::cos(x); };
  for (const double limit : {1.0, 10.0, 4096.0, 1e5, 1e15}) {
    expect_within(1, sin, sine, between(-limit, limit));
    expect_within(1, cos, cosine, between(-limit, limit));
  }
  expect_within(1, sin, sine, any);
  expect_within(1, cos, cosine, any);
  // The angles nearest to a multiple of π/2, of all and of those below 4096.
  for (const double x : {0x1.951fc5ba0e7aap+860, 6381956970095103 * 0x1p797, 0x1.921fb54442d18p+0,
                         0x1.921fb54442d18p+1, 0x1.6c6cbc45dc8dep+5, 0x1.9cba3p+10}) {
    EXPECT_LE(error(sin(x), std::sin(static_cast<long double>(x))), 1) << x;
    EXPECT_LE(error(cos(x), std::cos(static_cast<long double>(x))), 1) << x;
  }
}

TEST_F(Elementary, TangentAndArcSineAreWithinTwoUnits) {
  const auto tangent = [](long double x) { return std::tan(x); };
  expect_within(2, tan, tangent, between(-1.6, 1.6));
  expect_within(2, tan, tangent, any);
  const auto arc_sine = [](long double x) { return std::asin(x); };
  expect_within(2, asin, arc_sine, between(-1, 1));
  expect_within(2, asin, arc_sine, between(0.999999, 1));
}

TEST_F(Elementary, AnglesOfPointsAreWithinOneUnitAndLengthsWithinTwo) {
  const auto angle = [](long double y, long double x) { return std::atan2(y, x); };
  const auto length = [](long double y, long double x) { return std::hypot(y, x); };
  const auto near = [](Random& random) {
    const double y = random.uniform(-3, 3);
    return std::pair(y, random.uniform(-3, 3));
  };
  const auto far = [](Random& random) {
    const double y = any(random);
    return std::pair(y, y * random.uniform(-2, 2));
  };
  const auto apart = [](Random& random) {
    const double y = any(random);
    return std::pair(y, any(random));
  };
  expect_within_of_two(1, atan2, angle, near);
  expect_within_of_two(1, atan2, angle, far);
  expect_within_of_two(1, atan2, angle, apart);
  expect_within_of_two(2, hypot, length, near);
  expect_within_of_two(2, hypot, length, far);
  expect_within_of_two(2, hypot, length, apart);
}

TEST_F(Elementary, ErrorFunctionIsWithinTwoUnits) {
  const auto reference = [](long double x) { return std::erf(x); };
  expect_within(2, erf, reference, between(-7, 7));
  expect_within(2, erf, reference, between(-1, 1));
  expect_within(2, erf, reference, [](Random& random) { return 0.01 * any(random); });
}

/// Same value, sign of zero included; NaN is NaN.
bool same(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b && std::signbit(a) == std::signbit(b);
}

TEST(ElementarySpecialValues, AreThoseOfC) {
  EXPECT_TRUE(same(exp(infinity), infinity) && same(exp(-infinity), 0) && same(exp(0), 1));
  EXPECT_TRUE(same(exp(710), infinity) && same(exp(-746), 0) && same(exp(nan), nan));
  EXPECT_TRUE(same(exp(-745), least));
  EXPECT_TRUE(same(log(0), -infinity) && same(log(-0.0), -infinity) && same(log(1), 0));
  EXPECT_TRUE(same(log(infinity), infinity) && same(log(-1), nan) && same(log(nan), nan));
  for (double (*odd)(double) : {&sin, &tan, &asin, &erf}) {
    EXPECT_TRUE(same(odd(0), 0) && same(odd(-0.0), -0.0) && same(odd(nan), nan));
    EXPECT_TRUE(odd == &erf || (same(odd(infinity), nan) && same(odd(least), least)));
  }
  EXPECT_TRUE(same(cos(-infinity), nan) && same(cos(nan), nan) && same(cos(least), 1));
  EXPECT_TRUE(same(asin(1.0000001), nan) && same(erf(infinity), 1) && same(erf(-infinity), -1));
}

// Of two numbers the special cases are many: all pairs, against the library.
TEST(ElementarySpecialValues, OfTwoNumbersAreThoseOfC) {
  const std::vector<double> all = {0.0,   -0.0,   least, -least, 0.5,      -0.5,     1,      -1,
                                   2,     -2,     3,     -3,     1e20,     -1e20,    0x1p53, 9.5,
                                   1e300, -1e300, nan,   1e-300, infinity, -infinity};
  using Function = double (*)(double, double);
  struct Case {
    const char* name;
    Function ours, library;
  };
  const std::vector<Case> cases = {
      {"pow", &pow, [](double x, double y) { return std::pow(x, y); }},
      {"atan2", &atan2, [](double x, double y) { return std::atan2(x, y); }},
      {"hypot", &hypot, [](double x, double y) { return std::hypot(x, y); }}};
  for (const auto& [name, ours, library] : cases) {
    for (const double x : all) {
      for (const double y : all) {
        const bool hypot_of_nan = std::string(name) == "hypot" && (std::isnan(x) || std::isnan(y));
        const double got = ours(x, y), wanted = library(x, y);
        if (std::isfinite(wanted) && wanted != 0 && !hypot_of_nan) {
          EXPECT_LE(error(got, wanted), 1.5) << name << " of " << x << ", " << y;
        } else {
          EXPECT_TRUE(same(got, wanted)) << name << " of " << x << ", " << y << ": " << got;
        }
      }
    }
  }
}

// What every compiler, machine and library must give, WebAssembly included.
TEST(ElementaryFunctions, GiveTheSameBitsOnEveryMachine) {
  Random random(7);
  std::uint64_t hash = 0;
  const auto add = [&](double x) {
    if (std::isnan(x)) x = 1.25;  // its bits mean nothing
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    hash = hash_bits(hash ^ bits);
  };
  for (int i = 0; i < samples; ++i) {
    const double wide = from_bits(random.next()), near = random.uniform(-8, 8);
    const double x = i % 2 == 0 ? wide : near, positive = random.uniform(0, 4);
    for (double (*f)(double) : {&exp, &log, &sin, &cos, &tan, &asin, &erf}) add(f(x));
    for (double (*f)(double, double) : {&atan2, &hypot, &pow}) add(f(x, near)), add(f(positive, x));
  }
  EXPECT_EQ(hash, 0x543da553f6a7783eull);
}

}  // namespace
}  // namespace craze::elementary
