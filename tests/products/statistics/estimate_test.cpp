#include "craze/products/statistics/estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "craze/base/random.h"
#include "craze/products/statistics/gamma_fit.h"

namespace craze {
namespace {

TEST(Estimate, ErrorOfAMeanIsItsSpreadOverManySamples) {
  constexpr int n = 100, repeats = 2000;
  double sum = 0, squares = 0, error = 0;
  Random random(1);
  for (int k = 0; k < repeats; ++k) {
    std::vector<double> x;
    for (int i = 0; i < n; ++i) x.push_back(random.normal());
    const Estimate e = mean_of(x);
    sum += e.value;
    squares += e.value * e.value;
    error += e.error / repeats;
  }
  EXPECT_NEAR(error, std::sqrt(squares / repeats - std::pow(sum / repeats, 2)), 0.05 * error);
}

TEST(Estimate, BootstrapAgreesWithTheFormulaForAMean) {
  Random random(2);
  std::vector<double> x;
  for (int i = 0; i < 500; ++i) x.push_back(random.uniform());
  const Estimate formula = mean_of(x);
  const Estimate drawn = bootstrap(x.size(), {1000, 3}, [&](const std::vector<double>& w) {
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += w[i] * x[i];
      weight += w[i];
    }
    return sum / weight;
  });
  EXPECT_NEAR(drawn.value, formula.value, 1e-12);
  EXPECT_NEAR(drawn.error, formula.error, 0.1 * formula.error);
}

TEST(Estimate, NothingMeasuredIsNotANumber) {
  EXPECT_TRUE(std::isnan(mean_of({}).value));
  EXPECT_TRUE(std::isnan(fraction_of(0, 0).value));
  EXPECT_TRUE(std::isnan(mean_of({1.0}).error));
  EXPECT_GT(fraction_of(0, 20).error, 0) << "none of twenty is not certainly none";
}

TEST(GammaFit, PsiAndItsDerivativeHaveTheirKnownValues) {
  EXPECT_NEAR(digamma(1), -std::numbers::egamma, 1e-12);
  EXPECT_NEAR(digamma(0.5), -std::numbers::egamma - 2 * std::numbers::ln2, 1e-12);
  EXPECT_NEAR(trigamma(1), std::numbers::pi * std::numbers::pi / 6, 1e-12);
  for (const double x : {0.2, 1.7, 9.9, 42.0}) {
    EXPECT_NEAR(digamma(x + 1), digamma(x) + 1 / x, 1e-11);
    const double h = 1e-5;
    EXPECT_NEAR(trigamma(x), (digamma(x + h) - digamma(x - h)) / (2 * h), 1e-5 * trigamma(x));
  }
}

TEST(GammaFit, RecognisesTheLawThatAreasWereDrawnFrom) {
  Random random(4);
  std::vector<double> gamma, lognormal, ones;
  for (int i = 0; i < 4000; ++i) {
    double sum = 0;  // of three exponentials: gamma with k = 3
    for (int k = 0; k < 3; ++k) sum -= std::log(1 - random.uniform());
    gamma.push_back(sum);
    lognormal.push_back(std::exp(0.7 * random.normal()));
    ones.push_back(1);
  }
  const AreaLaw g = fit_area_law(gamma, ones), l = fit_area_law(lognormal, ones);
  EXPECT_NEAR(g.gamma_shape, 3, 0.2);
  EXPECT_GT(g.log_likelihood, 0);
  EXPECT_NEAR(l.sd_log, 0.7, 0.03);
  EXPECT_LT(l.log_likelihood, 0);
}

}  // namespace
}  // namespace craze
