// How stiff a mesh is: a bound on the largest eigenvalue of K, kept up as cracks cut it.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/stress_field.h"

namespace craze {

/// uᵀK u = Σ_e A|B u|² ≤ Σ_e Σ_ij u_i·u_j G_ij ≤ Σ_e Σ_i m_i |u_i|², with G_ij = A ∇λ_i·∇λ_j and
/// m_i G's largest eigenvalue, or where the element is thin Σ_j |G_ij| (a corner across the thin
/// side resists little, and at a pole many meet). So no eigenvalue of K exceeds the largest sum of
/// m_i around a node; nor any of K + κ M, M the diagonal of node areas, the largest sum plus κ A_n.
/// Dimensionless: K maps a virtual displacement to a force per the stress unit.
class StiffnessBound {
 public:
  /// adhesion: κ, 1/length².
  explicit StiffnessBound(double adhesion = 0) : adhesion_(adhesion) {}

  /// Takes in the nodes given, whose elements are new or changed. The bound never falls.
  void update(const TriangleMesh& mesh, const StressField& field,
              const std::vector<std::int32_t>& nodes);
  void update(const TriangleMesh& mesh, const StressField& field);

  /// 0 where no element resists anything.
  double value() const { return bound_; }

 private:
  void update(const TriangleMesh& mesh, const StressField& field, std::int32_t v);

  double adhesion_;
  double bound_ = 0;
};

}  // namespace craze
