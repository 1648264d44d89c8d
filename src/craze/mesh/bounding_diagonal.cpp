#include "craze/mesh/bounding_diagonal.h"

#include <cmath>

namespace craze {

double bounding_diagonal(const std::vector<Vec3>& positions, const Period& period) {
  if (period.is_given()) return std::sqrt(2.0) * period.length;
  if (positions.empty()) return 0;
  Vec3 low = positions.front(), high = low;
  for (const Vec3& p : positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

}  // namespace craze
