#include "craze/model/failure/separation_tensor.h"

#include <cmath>

namespace craze {

namespace {

/// Adds sign · m(a) and returns |a|. Without a branch: whether a vanishes is anyone's guess.
inline double add_m(Sym3& sum, double sign, const Vec3& a) {
  const double length = a.norm();
  add_outer(sum, length > 0 ? sign / length : 0, a);
  return length;
}

inline Vec3 corner_force(const Element& e, double t11, double t22, double t12, int corner) {
  const Vec3 f1 = -(t11 * e.edge1() + t12 * e.edge2());
  const Vec3 f2 = -(t12 * e.edge1() + t22 * e.edge2());
  return corner == 1 ? f1 : corner == 2 ? f2 : Vec3(-f1 - f2);
}

}  // namespace

SplitForce split_force(const Element& e, int corner) {
  const double t11 = e.t[0], t22 = e.t[1], t12 = e.t[2];
  const Vec3 whole = element_force(e, corner);
  // The principal stresses have the signs of T's eigenvalues: σ is T seen in another basis.
  const double det_t = t11 * t22 - t12 * t12;
  const double n11 = e.e1[3], n12 = e.e2[3], n22 = e.t[3];
  const double det_n = n11 * n22 - n12 * n12;
  if (det_t >= 0 || !(det_n > 0)) {
    if (t11 + t22 >= 0) return {whole, Vec3::Zero()};
    return {Vec3::Zero(), whole};
  }
  // One of each. The identity has the components of N, up to a factor, so σ's principal values are
  // the eigenvalues of T N⁻¹ times that factor, and σ⁺ = high (σ − low I) / (high − low) is this:
  const double half_trace = 0.5 * (t11 * n22 + t22 * n11 - 2 * t12 * n12) / det_n;
  const double radius = std::sqrt(half_trace * half_trace - det_t / det_n);
  const double high = half_trace + radius, low = half_trace - radius;
  const double s = 0.5 * high / radius;
  const Vec3 tensile =
      corner_force(e, s * (t11 - low * n11), s * (t22 - low * n22), s * (t12 - low * n12), corner);
  return {tensile, whole - tensile};
}

__attribute__((flatten)) SeparationTensor separation_tensor(const TriangleMesh& mesh,
                                                            const StressField& field,
                                                            std::int32_t v) {
  Sym3 sum;
  Vec3 tensile = Vec3::Zero(), compressive = Vec3::Zero();
  double lengths = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const SplitForce f = split_force(field.elements()[h / 3], h % 3);
    lengths += add_m(sum, 1, f.tensile);
    add_m(sum, -1, f.compressive);
    tensile += f.tensile;
    compressive += f.compressive;
  });
  add_m(sum, -1, tensile);
  lengths += add_m(sum, 1, compressive);
  return {0.5 * sum, 0.5 * lengths};
}

}  // namespace craze
