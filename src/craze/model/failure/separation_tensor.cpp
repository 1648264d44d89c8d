#include "craze/model/failure/separation_tensor.h"

#include <cmath>

#include "craze/base/simd.h"

namespace craze {

namespace {

// A vector in lanes 0 to 2; lane 3 holds nothing of use.
using Lanes = Vec4d::Lanes;

struct LaneForces {
  Lanes tensile, compressive;
};

/// f of Eq. 1 on a corner, for σ with the components T.
inline void corner_force(const Element& e, double t11, double t22, double t12, int corner,
                         Lanes& force) {
  const Lanes f1 = -(t11 * e.e1.v + t12 * e.e2.v);
  const Lanes f2 = -(t12 * e.e1.v + t22 * e.e2.v);
  force = corner == 1 ? f1 : corner == 2 ? f2 : -f1 - f2;
}

inline LaneForces split(const Element& e, int corner) {
  const double t11 = e.t[0], t22 = e.t[1], t12 = e.t[2];
  LaneForces forces;
  Lanes whole;
  corner_force(e, t11, t22, t12, corner, whole);
  // The principal stresses have the signs of T's eigenvalues: σ is T seen in another basis.
  const double det_t = t11 * t22 - t12 * t12;
  const double n11 = e.e1[3], n12 = e.e2[3], n22 = e.t[3];
  const double det_n = n11 * n22 - n12 * n12;
  if (det_t >= 0 || !(det_n > 0)) {
    const Lanes none = {0, 0, 0, 0};
    const bool pulls = t11 + t22 >= 0;
    forces.tensile = pulls ? whole : none;
    forces.compressive = pulls ? none : whole;
    return forces;
  }
  // One of each. The identity has the components of N, up to a factor, so σ's principal values are
  // the eigenvalues of T N⁻¹ times that factor, and σ⁺ = high (σ − low I) / (high − low) is this:
  const double half_trace = 0.5 * (t11 * n22 + t22 * n11 - 2 * t12 * n12) / det_n;
  const double radius = std::sqrt(half_trace * half_trace - det_t / det_n);
  const double high = half_trace + radius, low = half_trace - radius;
  const double s = 0.5 * high / radius;
  corner_force(e, s * (t11 - low * n11), s * (t22 - low * n22), s * (t12 - low * n12), corner,
               forces.tensile);
  forces.compressive = whole - forces.tensile;
  return forces;
}

/// Sums of m(a).
struct Sum {
  Lanes diagonal = {0, 0, 0, 0};  // xx, yy, zz
  Lanes off = {0, 0, 0, 0};       // xy, yz, zx

  /// Adds sign · m(a) and returns |a|. Without a branch: whether a vanishes is anyone's guess.
  double add(double sign, const Lanes& a) {
    const Lanes squares = a * a;
    const double length = std::sqrt(squares[0] + (squares[1] + squares[2]));
    const Lanes scaled = (length > 0 ? sign / length : 0) * a;
    diagonal += scaled * a;
    off += scaled * __builtin_shufflevector(a, a, 1, 2, 0, 3);
    return length;
  }
};

CRAZE_WIDE __attribute__((flatten)) void separate(const TriangleMesh& mesh,
                                                  const StressField& field, std::int32_t v,
                                                  SeparationTensor& result) {
  Sum sum;
  Lanes tensile = {0, 0, 0, 0}, compressive = {0, 0, 0, 0};
  double lengths = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const LaneForces f = split(field.elements()[h / 3], h % 3);
    lengths += sum.add(1, f.tensile);
    sum.add(-1, f.compressive);
    tensile += f.tensile;
    compressive += f.compressive;
  });
  sum.add(-1, tensile);
  lengths += sum.add(1, compressive);
  const Lanes diagonal = 0.5 * sum.diagonal, off = 0.5 * sum.off;
  result.tensor = {diagonal[0], diagonal[1], diagonal[2], off[0], off[1], off[2]};
  result.bound = 0.5 * lengths;
}

}  // namespace

SplitForce split_force(const Element& e, int corner) {
  const LaneForces f = split(e, corner);
  return {{f.tensile[0], f.tensile[1], f.tensile[2]},
          {f.compressive[0], f.compressive[1], f.compressive[2]}};
}

SeparationTensor separation_tensor(const TriangleMesh& mesh, const StressField& field,
                                   std::int32_t v) {
  SeparationTensor result;
  separate(mesh, field, v, result);
  return result;
}

}  // namespace craze
