#include "craze/model/failure/direction_bias.h"

#include <algorithm>
#include <cmath>

namespace craze {

namespace {

// Below this share of the mean curvature a direction is trusted less than half.
constexpr double trusted_share = 0.25;

}  // namespace

std::vector<PreferredDirection> preferred_directions(
    std::span<const PrincipalCurvature> curvature) {
  std::vector<PreferredDirection> preferred(curvature.size());
  double mean = 0;
  for (const PrincipalCurvature& c : curvature) mean += c.frobenius();
  if (mean <= 0) return preferred;
  const double trusted = trusted_share * mean / static_cast<double>(curvature.size());
  for (std::size_t v = 0; v < curvature.size(); ++v) {
    const PrincipalCurvature& c = curvature[v];
    const double a = std::abs(c.k1), b = std::abs(c.k2);
    if (a + b <= 0) continue;
    const double size = c.sum_of_squares();
    preferred[v].along = a < b ? c.direction1 : c.direction2;
    preferred[v].confidence = std::abs(a - b) / (a + b) * size / (size + trusted * trusted);
  }
  return preferred;
}

Sym3 bias_direction(const Sym3& separation, const PreferredDirection& preferred, double bias) {
  const double s = 1 - std::sqrt(std::max(0.0, 1 - bias * preferred.confidence));
  if (s <= 0) return separation;
  // S ς S = ς − s (t gᵀ + g tᵀ) + s² (t·g) t tᵀ, g = ς t.
  const Vec3& t = preferred.along;
  const Vec3 g = separation * t;
  Sym3 biased = separation;
  add_outer(biased, s * s * t.dot(g), t);
  biased.xx -= 2 * s * t.x() * g.x();
  biased.yy -= 2 * s * t.y() * g.y();
  biased.zz -= 2 * s * t.z() * g.z();
  biased.xy -= s * (t.x() * g.y() + t.y() * g.x());
  biased.yz -= s * (t.y() * g.z() + t.z() * g.y());
  biased.zx -= s * (t.z() * g.x() + t.x() * g.z());
  return biased;
}

}  // namespace craze
