#include "craze/model/relaxation/stiffness_bound.h"

#include <algorithm>
#include <cmath>

namespace craze {

namespace {

/// m_i of a corner. G = A ∇λ_i·∇λ_j; of corners 1 and 2 it is √A N, and its rows sum to zero.
double corner_bound(const TriangleMesh& mesh, const StressField& field, std::int32_t f,
                    int corner) {
  const Element& e = field.elements()[f];
  const double scale = std::sqrt(mesh.area(f));
  const double g11 = scale * e.e1[3], g12 = scale * e.e2[3], g22 = scale * e.t[3];
  const double g01 = -(g11 + g12), g02 = -(g12 + g22), g00 = -(g01 + g02);
  const double rows[3] = {g00 + std::abs(g01) + std::abs(g02), std::abs(g01) + g11 + std::abs(g12),
                          std::abs(g02) + std::abs(g12) + g22};
  // G's eigenvalues are 0 and those of [2 1; 1 2] √A N.
  const double half_trace = g11 + g12 + g22;
  const double determinant = 3 * (g11 * g22 - g12 * g12);
  const double eigenvalue =
      half_trace + std::sqrt(std::max(0.0, half_trace * half_trace - determinant));
  const bool thin = std::min({rows[0], rows[1], rows[2]}) < 0.5 * eigenvalue;
  return thin ? rows[corner] : eigenvalue;
}

}  // namespace

void StiffnessBound::update(const TriangleMesh& mesh, const StressField& field, std::int32_t v) {
  double sum = adhesion_ * field.node_areas()[v];
  mesh.for_each_outgoing(v,
                         [&](std::int32_t h) { sum += corner_bound(mesh, field, h / 3, h % 3); });
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
