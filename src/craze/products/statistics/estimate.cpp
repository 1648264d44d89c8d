#include "craze/products/statistics/estimate.h"

#include <cmath>

#include "craze/base/random.h"

namespace craze {

Estimate mean_of(const std::vector<double>& x, const std::vector<double>& weights) {
  return ratio_of(x, std::vector<double>(x.size(), 1.0), weights);
}

Estimate ratio_of(const std::vector<double>& y, const std::vector<double>& x,
                  const std::vector<double>& weights) {
  Estimate e;
  const std::size_t n = x.size();
  const auto weight = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  double sum_x = 0, sum_y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sum_x += weight(i) * x[i];
    sum_y += weight(i) * y[i];
  }
  if (n == 0 || sum_x == 0) return e;
  e.value = sum_y / sum_x;
  if (n < 2) return e;
  double residual = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double d = weight(i) * (y[i] - e.value * x[i]);
    residual += d * d;
  }
  e.error =
      std::sqrt(residual * static_cast<double>(n) / static_cast<double>(n - 1)) / std::abs(sum_x);
  return e;
}

Estimate fraction_of(std::int64_t hits, std::int64_t n) {
  Estimate e;
  if (n == 0) return e;
  const double m = static_cast<double>(n);
  e.value = static_cast<double>(hits) / m;
  const double p = (static_cast<double>(hits) + 2) / (m + 4);
  e.error = std::sqrt(p * (1 - p) / (m + 4));
  return e;
}

Estimate bootstrap(std::size_t n, const Bootstrap& options,
                   const std::function<double(const std::vector<double>&)>& statistic) {
  Estimate e;
  if (n == 0) return e;
  std::vector<double> drawn(n, 1.0);
  e.value = statistic(drawn);
  if (options.resamples < 2 || n < 2) return e;
  Random random(options.seed, 0x626f6f74);  // "boot"
  double sum = 0, sum_squares = 0;
  int count = 0;
  for (int k = 0; k < options.resamples; ++k) {
    options.context.check();
    drawn.assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) drawn[random.below(n)] += 1;
    const double d = statistic(drawn) - e.value;
    if (!std::isfinite(d)) continue;
    sum += d;
    sum_squares += d * d;
    ++count;
  }
  if (count < 2) return e;
  e.error = std::sqrt(std::max(0.0, (sum_squares - sum * sum / count) / (count - 1)));
  return e;
}

double variation(const std::vector<double>& x, const std::vector<double>& weights) {
  double sum = 0, mean = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += weights[i];
    mean += weights[i] * x[i];
  }
  if (sum == 0 || mean == 0) return std::numeric_limits<double>::quiet_NaN();
  mean /= sum;
  double variance = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    variance += weights[i] * (x[i] - mean) * (x[i] - mean);
  }
  return std::sqrt(variance / sum) / mean;
}

}  // namespace craze
