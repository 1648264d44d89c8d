// The steps by which the flow u' = F is followed: Euler's, or far fewer that end in the same place.
#pragma once

#include <cstdint>
#include <vector>

namespace craze {

/// Δp ← momentum · Δp + time_step · F; what is left of it in the end is weight · Δp.
struct RelaxationStep {
  double momentum = 0, time_step = 0, weight = 1;
};

/// R times [IO06 Eq. 3], Δp = Δt F.
std::vector<RelaxationStep> euler_steps(std::int64_t count, double time_step);

/// The same map as `count` Euler steps, p(K) = (1 − Δt K)^R, by a Chebyshev series in about
/// 2.8 √(R Δt Λ / 2) steps; or, where Euler steps of that size are unstable (Δt Λ > 2), the exact
/// flow p(K) = exp(−R Δt K) in as few. Λ: an upper bound on the eigenvalues of K.
///
/// With x = 1 − 2K/Λ both are Σ c_k T_k(x) with all c_k ≥ 0 and Σ c_k = 1, and stay so when the
/// last terms are left out and their weight is given to the others. Hence |p| ≤ 1: energy never
/// rises, whatever Δt. p(0) = 1 and p'(0) are kept exactly; elsewhere p is off by at most 0.01.
/// Source: the series is the expectation of T_|S|(x) over a lazy random walk S of R steps;
/// Chebyshev recurrence as in van der Houwen and Sommeijer, "On the internal stability of explicit
/// m-stage Runge–Kutta methods" (1980).
std::vector<RelaxationStep> accelerated_steps(double count, double time_step, double stiffness);

/// The most steps of that size that accelerated_steps should be asked for at once: beyond, single
/// precision would tell. May be below 1, where Euler steps are unstable.
double most_steps_at_once(double time_step, double stiffness);

}  // namespace craze
