#include "craze/products/statistics/gamma_fit.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "craze/base/elementary.h"

namespace craze {

// All three: recurrence up to x ≥ 10, then the asymptotic series (Abramowitz &
// Stegun 6.1.41, 6.3.18, 6.4.12).

double log_gamma(double x) {
  double product = 1;
  for (; x < 10; ++x) product *= x;
  const double y = 1 / (x * x);
  return (x - 0.5) * elementary::log(x) - x + 0.5 * elementary::log(2 * std::numbers::pi) +
         (1. / 12 - y * (1. / 360 - y * (1. / 1260 - y * (1. / 1680 - y / 1188)))) / x -
         elementary::log(product);
}

double digamma(double x) {
  double shift = 0;
  for (; x < 10; ++x) shift -= 1 / x;
  const double y = 1 / (x * x);
  return shift + elementary::log(x) - 0.5 / x -
         y * (1. / 12 - y * (1. / 120 - y * (1. / 252 - y * (1. / 240 - y / 132))));
}

double trigamma(double x) {
  double shift = 0;
  for (; x < 10; ++x) shift += 1 / (x * x);
  const double y = 1 / (x * x);
  return shift + 1 / x + y / 2 +
         y / x * (1. / 6 - y * (1. / 30 - y * (1. / 42 - y * (1. / 30 - y * 5. / 66))));
}

AreaLaw fit_area_law(const std::vector<double>& areas, const std::vector<double>& weights) {
  double sum = 0, mean = 0, mean_log = 0, variance_log = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    sum += weights[i];
    mean += weights[i] * areas[i];
    mean_log += weights[i] * elementary::log(areas[i]);
  }
  mean /= sum;
  mean_log /= sum;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const double d = elementary::log(areas[i]) - mean_log;
    variance_log += weights[i] * d * d / sum;
  }
  AreaLaw law;
  law.sd_log = std::sqrt(variance_log);
  const double s = elementary::log(mean) - mean_log;  // of a gamma law: ln k − ψ(k)
  if (s < 1e-9 || variance_log <= 0) {
    law.gamma_shape = law.log_likelihood = std::numeric_limits<double>::quiet_NaN();
    return law;
  }
  // Newton on ln k − ψ(k) = s in ln k, from Minka's closed-form guess.
  double k = (3 - s + std::sqrt((s - 3) * (s - 3) + 24 * s)) / (12 * s);
  for (int i = 0; i < 20; ++i) {
    const double step = (elementary::log(k) - digamma(k) - s) / (1 - k * trigamma(k));
    k *= elementary::exp(-step);
    if (std::abs(step) < 1e-12) break;
  }
  law.gamma_shape = k;
  const double gamma = (k - 1) * mean_log - k - log_gamma(k) + k * elementary::log(k / mean);
  const double lognormal =
      -mean_log - elementary::log(law.sd_log) - 0.5 * elementary::log(2 * std::numbers::pi) - 0.5;
  law.log_likelihood = gamma - lognormal;
  return law;
}

}  // namespace craze
