// Smooth random fields in space.
//
// References
// Lewis: Algorithms for solid noise synthesis. SIGGRAPH 1989 (sparse convolution).
#pragma once

#include <cstdint>
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
  double at(const Vec3& position) const;

 private:
  double radius_;             // of the kernel
  double cell_ = 1;           // width of a cell along x and y, radii, ≥ 1
  std::int64_t repeats_ = 0;  // after so many cells along x and y; 0: never
  Random random_;
};

/// #F values at the centroids; throws Cancelled. length = 0: each triangle's value is drawn by
/// itself, standard normal, by its index.
std::vector<double> face_noise(const TriangleMesh& mesh, double length, const Random& random,
                               const Context& context);
/// #V values at the vertices; length = 0: drawn by index.
std::vector<double> vertex_noise(const TriangleMesh& mesh, double length, const Random& random,
                                 const Context& context);

}  // namespace craze
