#include "craze/model/stiffness_bound.h"

#include <algorithm>
#include <cmath>

namespace craze {

namespace {

/// λ_e = A s². With G the 3×2 gradients, GᵀG and M ββᵀ, M = [2 1; 1 2], share their eigenvalues;
/// N = √A ββᵀ.
double element_bound(const TriangleMesh& mesh, const StressField& field, std::int32_t f) {
  const Element& e = field.elements()[f];
  const double n11 = e.e1[3], n12 = e.e2[3], n22 = e.t[3];
  const double half_trace = n11 + n12 + n22;
  const double determinant = 3 * (n11 * n22 - n12 * n12);
  const double root = std::sqrt(std::max(0.0, half_trace * half_trace - determinant));
  return std::sqrt(mesh.area(f)) * (half_trace + root);
}

}  // namespace

void StiffnessBound::update(const TriangleMesh& mesh, const StressField& field, std::int32_t v) {
  double sum = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) { sum += element_bound(mesh, field, h / 3); });
  bound_ = std::max(bound_, sum);
}

void StiffnessBound::update(const TriangleMesh& mesh, const StressField& field,
                            const std::vector<std::int32_t>& nodes) {
  for (const std::int32_t v : nodes) update(mesh, field, v);
}

void StiffnessBound::update(const TriangleMesh& mesh, const StressField& field) {
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) update(mesh, field, v);
}

}  // namespace craze
