// Space in cubes, for finding what is near.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "craze/base/random.h"
#include "craze/tensor.h"

namespace craze {

/// Keys for a hash map of points by cube. Keys of far cubes may collide: compare positions.
class CellGrid {
 public:
  /// size: of a cube, length, > 0.
  explicit CellGrid(double size) : size_(size) {}

  std::uint64_t key(const Vec3& p) const { return key(index(p.x()), index(p.y()), index(p.z())); }

  /// Calls visit(key) for every cube that has points within `radius` of p, or may have.
  template <class Visit>
  void for_each_near(const Vec3& p, double radius, Visit&& visit) const {
    const std::int64_t x1 = index(p.x() + radius), y1 = index(p.y() + radius),
                       z1 = index(p.z() + radius);
    for (std::int64_t x = index(p.x() - radius); x <= x1; ++x) {
      for (std::int64_t y = index(p.y() - radius); y <= y1; ++y) {
        for (std::int64_t z = index(p.z() - radius); z <= z1; ++z) visit(key(x, y, z));
      }
    }
  }

 private:
  std::int64_t index(double x) const {
    // Far out all is one cube: whatever the size, a number that fits.
    constexpr double farthest = 4e18;
    return static_cast<std::int64_t>(
        std::max(-farthest, std::min(farthest, std::floor(x / size_))));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    return hash_bits(
        static_cast<std::uint64_t>(x) ^
        hash_bits(static_cast<std::uint64_t>(y) ^ hash_bits(static_cast<std::uint64_t>(z))));
  }

  double size_;
};

}  // namespace craze
