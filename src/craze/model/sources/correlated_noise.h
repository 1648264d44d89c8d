// Smooth random fields in space.
//
// References
// Lewis: Algorithms for solid noise synthesis. SIGGRAPH 1989 (sparse convolution).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "craze/base/period.h"
#include "craze/base/random.h"
#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// A random function of position: mean 0, standard deviation 1, nearly normal, the same statistics
/// in every place and direction. Two points a distance d apart have correlation close to
/// exp(−d²/L²), exactly 1/e at d = L, and none beyond 3.05 L. It knows nothing of any mesh. With a
/// period it repeats, and L is at most what fits into one, 0.65 of it.
class CorrelatedNoise {
 public:
  /// length: L > 0.
  CorrelatedNoise(double length, const Random& random, Period period = {});

  /// What a value is made of, kept for the next one: places near each other need the same. For one
  /// thread at a time, and one noise.
  class Impulses;

  double at(const Vec3& position) const;
  double at(const Vec3& position, Impulses& last) const;

 private:
  double radius_;             // of the kernel
  double cell_ = 1;           // width of a cell along x and y, radii, ≥ 1
  std::int64_t repeats_ = 0;  // after so many cells along x and y; 0: never
  Random random_;
};

class CorrelatedNoise::Impulses {
 private:
  friend class CorrelatedNoise;
  static constexpr int per_cell = 4, count = 27 * per_cell;

  void find(const Vec3& corner, const CorrelatedNoise& noise);
  double sum(const Vec3& inside) const;

  Vec3 corner_ = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  // of the middle cell
  double x_[count], y_[count], z_[count], sign_[count];  // from there, in radii; ±1
};

/// #F values at the centroids; throws Cancelled. length = 0: each triangle's value is drawn by
/// itself, standard normal, by its index.
std::vector<double> face_noise(const TriangleMesh& mesh, double length, const Random& random,
                               const Context& context);
/// #V values at the vertices; length = 0: drawn by index.
std::vector<double> vertex_noise(const TriangleMesh& mesh, double length, const Random& random,
                                 const Context& context);

}  // namespace craze
