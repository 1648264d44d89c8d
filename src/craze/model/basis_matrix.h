// The barycentric basis matrix β of a triangle, and the cap on its singular values.
//
// [IO06] §3.3: β turns positions into barycentric coordinates; §4.2: its singular values are
// limited so that slivers do not make the explicit relaxation unstable.
#pragma once

#include <span>

#include "craze/mesh/triangle_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// The gradients of the barycentric coordinates of corners 1 and 2 in the triangle's frame
/// (tangent_frame.h), as rows, 1/length. Corner 0's is minus their sum. The paper's 3×3 β holds
/// these and a column of constants that no equation but Eq. 4 needs.
Mat2 basis_matrix(const Vec3& p0, const Vec3& p1, const Vec3& p2);

/// Singular values of the gradients of all three barycentric coordinates, a 3×2 matrix of which
/// `beta` holds the last two rows: the same whichever corner comes first. 1/length.
struct SingularValues {
  double largest, smallest;
};
SingularValues singular_values(const Mat2& beta);

/// β rebuilt with no singular value above `cap` ([IO06] §4.2): the sliver becomes more compliant in
/// the capped direction and is unchanged in the other. cap = ∞ leaves β as it is.
Mat2 cap_singular_values(const Mat2& beta, double cap);

/// The cap for a mesh: 1.5 times the 0.95 quantile of the largest singular values of its triangles,
/// so that a few slivers in the input do not lift it. 1/length.
double singular_value_cap(const TriangleMesh& mesh);

}  // namespace craze
