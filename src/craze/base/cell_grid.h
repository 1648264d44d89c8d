// Space in cubes, for finding what is near.
#pragma once

#include <cmath>
#include <cstdint>

#include "craze/base/random.h"
#include "craze/base/tensor.h"

namespace craze {

/// Keys for a hash map of points by cube. Points nearer to each other than the cubes' size are in
/// the same or in neighbouring cubes. Keys of far cubes may collide: compare positions.
class CellGrid {
 public:
  /// size: of a cube, length, > 0.
  explicit CellGrid(double size) : size_(size) {}

  std::uint64_t key(const Vec3& p) const { return key(p, 0, 0, 0); }

  /// Calls visit(key) for the cube of p and the 26 around it.
  template <class Visit>
  void for_each_near(const Vec3& p, Visit&& visit) const {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) visit(key(p, dx, dy, dz));
      }
    }
  }

 private:
  std::uint64_t key(const Vec3& p, int dx, int dy, int dz) const {
    const auto index = [&](double x, int d) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / size_)) + d);
    };
    return hash_bits(index(p.x(), dx) ^ hash_bits(index(p.y(), dy) ^ hash_bits(index(p.z(), dz))));
  }

  double size_;
};

}  // namespace craze
