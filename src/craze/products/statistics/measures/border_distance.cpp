#include "craze/products/statistics/measures/border_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace craze {
namespace {

double distance(const Vec3& p, const BorderSegment& s) {
  const Vec3 d = s.b - s.a;
  const double length = d.squaredNorm();
  const double t = length > 0 ? std::clamp((p - s.a).dot(d) / length, 0.0, 1.0) : 0.0;
  return (p - s.a - t * d).norm();
}

}  // namespace

std::vector<char> near_border(const std::vector<Vec3>& points,
                              const std::vector<BorderSegment>& border, double limit) {
  std::vector<char> near(points.size(), 0);
  if (border.empty()) return near;
  // Points in cubes of side `limit`; each segment looks into the cubes along it.
  using Cube = std::array<std::int64_t, 3>;
  const auto cube_of = [&](const Vec3& p) {
    return Cube{std::llround(std::floor(p.x() / limit)), std::llround(std::floor(p.y() / limit)),
                std::llround(std::floor(p.z() / limit))};
  };
  std::map<Cube, std::vector<std::size_t>> cubes;
  for (std::size_t i = 0; i < points.size(); ++i) cubes[cube_of(points[i])].push_back(i);
  for (const BorderSegment& whole : border) {
    const double length = (whole.b - whole.a).norm() / limit;
    // Where the way crosses more cubes than there are points, each point is asked instead: the cost
    // is bounded whatever the limit.
    if (!(length < static_cast<double>(points.size()))) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (!near[i] && distance(points[i], whole) <= limit) near[i] = 1;
      }
      continue;
    }
    const auto pieces = static_cast<std::size_t>(std::ceil(length)) + 1;
    for (std::size_t k = 0; k < pieces; ++k) {
      const Vec3 step = (whole.b - whole.a) / static_cast<double>(pieces);
      const BorderSegment s{whole.a + static_cast<double>(k) * step,
                            whole.a + static_cast<double>(k + 1) * step};
      const Cube low = cube_of(s.a.cwiseMin(s.b).array() - limit);
      const Cube high = cube_of(s.a.cwiseMax(s.b).array() + limit);
      for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
          for (std::int64_t z = low[2]; z <= high[2]; ++z) {
            const auto cube = cubes.find({x, y, z});
            if (cube == cubes.end()) continue;
            for (const std::size_t i : cube->second) {
              if (!near[i] && distance(points[i], s) <= limit) near[i] = 1;
            }
          }
        }
      }
    }
  }
  return near;
}

}  // namespace craze
