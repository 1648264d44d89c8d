// A measured number with its standard error.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "craze/context.h"

namespace craze {

/// NaN stands for "not measured": too few samples, or not known for this input.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();  ///< one standard error
};

/// Σwx/Σw with the error of a ratio of means. Weights empty: all 1.
Estimate mean_of(const std::vector<double>& x, const std::vector<double>& weights = {});

/// Σwy/Σwx with its linearised error.
Estimate ratio_of(const std::vector<double>& y, const std::vector<double>& x,
                  const std::vector<double>& weights = {});

/// hits of n, with the binomial error; near 0 and 1 that of Agresti and Coull, never zero.
Estimate fraction_of(std::int64_t hits, std::int64_t n);

/// How standard errors without a formula are found.
struct Bootstrap {
  int resamples = 200;  ///< 0: values only, errors stay NaN
  std::uint64_t seed = 1;
  Context context = {};  ///< asked before each resample whether to stop
};

/// value = statistic(multiplicities all 1); error = its standard deviation over resamples of the n
/// items with replacement. The statistic gets how often each item was drawn, as a weight.
/// Throws Cancelled.
Estimate bootstrap(std::size_t n, const Bootstrap& options,
                   const std::function<double(const std::vector<double>&)>& statistic);

/// Weighted standard deviation over weighted mean.
double variation(const std::vector<double>& x, const std::vector<double>& weights);

}  // namespace craze
