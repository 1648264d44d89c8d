#include "craze/products/solids/inner_directions.h"

#include <algorithm>
#include <cstddef>

#include "craze/base/elementary.h"

namespace craze {

std::vector<Vec3> inner_directions(const std::vector<Vec3>& positions,
                                   const std::vector<Triangle>& triangles) {
  std::vector<Vec3> sum(positions.size(), Vec3::Zero());
  std::vector<double> angles(positions.size(), 0);
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = positions[t[i]];
      const Vec3 a = positions[t[(i + 1) % 3]] - p, b = positions[t[(i + 2) % 3]] - p;
      const Vec3 normal = a.cross(b);
      const double length = normal.norm();
      if (!(length > 0)) continue;
      const double angle = elementary::atan2(length, a.dot(b));
      sum[t[i]] += angle / length * normal;
      angles[t[i]] += angle;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) {
    const double length = sum[v].norm();
    if (!(length > 0)) continue;
    // |Σ α n| / Σ α is the mean cosine between the direction and the faces' normals.
    sum[v] *= std::min(longest_mitre, angles[v] / length) / length;
  }
  return sum;
}

}  // namespace craze
