#include "craze/model/relaxation/relaxation_schedule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/base/elementary.h"

namespace craze {

namespace {

constexpr double left_out = 0.0045;    // weight of the terms left out, about half the error in p
constexpr double most_variance = 1e5;  // of the random walk: about 900 steps

/// c_k for k ≤ `degree` of Σ c_k T_k(x) = p(x), by Gauss–Chebyshev quadrature.
template <class Function>
std::vector<double> chebyshev_coefficients(int degree, const Function& p) {
  const int points = 2 * (degree + 1);
  std::vector<double> values(points);
  for (int j = 0; j < points; ++j) {
    values[j] = p(elementary::cos(std::numbers::pi * (j + 0.5) / points));
  }
  std::vector<double> c(degree + 1);
  for (int k = 0; k <= degree; ++k) {
    double sum = 0;
    for (int j = 0; j < points; ++j) {
      sum += values[j] * elementary::cos(std::numbers::pi * k * (j + 0.5) / points);
    }
    c[k] = std::max(0.0, (k == 0 ? 1.0 : 2.0) / points * sum);
  }
  return c;
}

/// Leaves out the last terms and makes Σ c_k = 1 and Σ c_k k² = variance, that is p and p' at x
/// = 1.
void truncate(std::vector<double>& c, double variance) {
  double sum = 0;
  for (const double weight : c) sum += weight;
  double kept = 0;
  std::size_t size = 0;
  while (size < c.size() && kept < (1 - left_out) * sum) kept += c[size++];
  c.resize(std::max<std::size_t>(size, 2));
  const auto last = static_cast<double>(c.size() - 1);
  c.back() += std::max(0.0, 1 - kept);
  double second = 0;
  for (std::size_t k = 0; k < c.size(); ++k) {
    second += c[k] * static_cast<double>(k) * static_cast<double>(k);
  }
  const double shift = std::clamp((variance - second) / (last * last - second), 0.0, 1.0);
  for (double& weight : c) weight *= 1 - shift;
  c.back() += shift;
}

}  // namespace

std::vector<RelaxationStep> euler_steps(std::int64_t count, double time_step) {
  return std::vector<RelaxationStep>(count, {0, time_step, 1});
}

double most_steps_at_once(double time_step, double stiffness) {
  return most_variance / (0.5 * time_step * stiffness);
}

std::vector<RelaxationStep> accelerated_steps(double count, double time_step, double stiffness) {
  // An Euler step is 1 − a (1 − x): a step of a random walk that stays with probability 1 − a.
  const double a = 0.5 * time_step * stiffness;
  const double variance = count * a;
  const int degree = static_cast<int>(std::ceil(5 * std::sqrt(variance))) + 8;
  std::vector<double> c = chebyshev_coefficients(degree, [&](double x) {
    return a <= 1 ? elementary::pow(1 - a * (1 - x), count) : elementary::exp(-variance * (1 - x));
  });
  truncate(c, variance);

  std::vector<RelaxationStep> steps(c.size() - 1, {1, 4 / stiffness, 0});
  steps[0] = {0, 2 / stiffness, 0};
  double weight = 0;
  for (std::size_t k = steps.size(); k > 0; --k) {
    weight += c[k];
    steps[k - 1].weight = weight;
  }
  return steps;
}

}  // namespace craze
