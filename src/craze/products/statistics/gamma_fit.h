// Which law do the cell areas follow: gamma or lognormal?
#pragma once

#include <vector>

namespace craze {

/// ψ(x) = Γ'(x)/Γ(x) and its derivative, x > 0, to about 10⁻¹².
double digamma(double x);
double trigamma(double x);

struct AreaLaw {
  double gamma_shape = 0;     ///< k of the gamma law of greatest likelihood; NaN for equal areas
  double sd_log = 0;          ///< standard deviation of ln A, σ of the lognormal law
  double log_likelihood = 0;  ///< gamma's less lognormal's, per cell: positive favours gamma
};

/// Areas positive, not empty; weights of the same size.
AreaLaw fit_area_law(const std::vector<double>& areas, const std::vector<double>& weights);

}  // namespace craze
