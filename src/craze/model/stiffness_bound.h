// How stiff a mesh is: a bound on the largest eigenvalue of K, kept up as cracks cut it.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/stress_field.h"

namespace craze {

/// uᵀK u = Σ_e A|B u|² ≤ Σ_e λ_e |u_e|² with λ_e = A s², s the element's largest singular value of
/// ∇λ (basis_matrix.h); so no eigenvalue of K exceeds the largest sum of λ_e around a node.
/// Dimensionless: K maps a virtual displacement to a force per the stress unit.
class StiffnessBound {
 public:
  /// Takes in the nodes given, whose elements are new or changed. The bound never falls.
  void update(const TriangleMesh& mesh, const StressField& field,
              const std::vector<std::int32_t>& nodes);
  void update(const TriangleMesh& mesh, const StressField& field);

  /// 0 where no element resists anything.
  double value() const { return bound_; }

 private:
  void update(const TriangleMesh& mesh, const StressField& field, std::int32_t v);

  double bound_ = 0;
};

}  // namespace craze
