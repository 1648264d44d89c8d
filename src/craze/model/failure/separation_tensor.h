// [IO06] §3.4, Eq. 2: the separation tensor of a node. Its largest eigenvalue is v⁺, the unit
// eigenvector n̂⁺ the normal of the crack plane: see largest_eigenpair().
#pragma once

#include <cstdint>

#include "craze/base/symmetric_eigen.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/stress_field.h"
#include "craze/tensor.h"

namespace craze {

/// The forces of one element on a corner, split by the signs of the principal stresses; force.
struct SplitForce {
  Vec3 tensile;      ///< from σ⁺
  Vec3 compressive;  ///< from σ⁻; the two add up to Eq. 1
};
SplitForce split_force(const Element& element, int corner);

/// ς of Eq. 2, force: ½ (−m(f⁺) + Σ m(f⁺ₑ) + m(f⁻) − Σ m(f⁻ₑ)) over the elements e around v, with
/// m(a) = a aᵀ / |a| (O'Brien & Hodgins 1999), so that |a| is m's eigenvalue.
/// `bound` is ½ (Σ |f⁺ₑ| + |f⁻|), which no eigenvalue of ς exceeds.
struct SeparationTensor {
  Sym3 tensor;
  double bound = 0;
};
SeparationTensor separation_tensor(const TriangleMesh& mesh, const StressField& field,
                                   std::int32_t v);

}  // namespace craze
