// The largest eigenvalue of a symmetric 3×3 tensor, without iteration.
#pragma once

#include "craze/tensor.h"

namespace craze {

struct Eigenpair {
  double value = 0;
  Vec3 vector = Vec3::Zero();
};

/// The largest eigenvalue (largest, not largest in size) and a unit eigenvector, both to rounding,
/// whether or not eigenvalues meet. The sign of the vector means nothing; where the largest value
/// is shared, the vector is one of its plane.
///
/// The root of the characteristic polynomial that stands apart from the other two is well
/// conditioned and has a well conditioned eigenvector; the rest is a 2×2 problem in the plane
/// across it (after D. Eberly, A Robust Eigensolver for 3×3 Symmetric Matrices, 2014).
Eigenpair largest_eigenpair(const Sym3& tensor);

}  // namespace craze
