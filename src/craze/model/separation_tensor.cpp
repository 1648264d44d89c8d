#include "craze/model/separation_tensor.h"

#include <algorithm>

namespace craze {

namespace {

void add_m(Sym3& sum, double sign, const Vec3& a) {
  const double length = a.norm();
  if (length > 0) add_outer(sum, sign / length, a);
}

Vec3 corner_force(const Element& e, double t11, double t22, double t12, int corner) {
  const Vec3 f1 = -(t11 * e.edge1() + t12 * e.edge2());
  const Vec3 f2 = -(t12 * e.edge1() + t22 * e.edge2());
  return corner == 1 ? f1 : corner == 2 ? f2 : Vec3(-f1 - f2);
}

}  // namespace

SplitForce split_force(const Element& e, int corner) {
  const double t11 = e.t[0], t22 = e.t[1], t12 = e.t[2];
  const Vec3 e1 = e.edge1(), e2 = e.edge2();
  const double g11 = e1.dot(e1), g22 = e2.dot(e2), g12 = e1.dot(e2);
  const double det_g = g11 * g22 - g12 * g12;
  const Vec3 whole = element_force(e, corner);
  if (!(det_g > 0)) return {Vec3::Zero(), Vec3::Zero()};

  // The principal values of A σ are those of the mixed tensor T G, G_ab = e_a·e_b.
  const double half_trace = 0.5 * (t11 * g11 + t22 * g22) + t12 * g12;
  const double determinant = (t11 * t22 - t12 * t12) * det_g;
  const double radius = std::sqrt(std::max(0.0, half_trace * half_trace - determinant));
  const double high = half_trace + radius, low = half_trace - radius;
  if (low >= 0) return {whole, Vec3::Zero()};
  if (high <= 0) return {Vec3::Zero(), whole};
  // One of each: σ⁺ = high (σ − low I) / (high − low); I has the components G⁻¹.
  const double s = high / (high - low), i = low / det_g;
  const Vec3 tensile =
      corner_force(e, s * (t11 - i * g22), s * (t22 - i * g11), s * (t12 + i * g12), corner);
  return {tensile, whole - tensile};
}

SeparationTensor separation_tensor(const TriangleMesh& mesh, const StressField& field,
                                   std::int32_t v) {
  Sym3 sum;
  Vec3 tensile = Vec3::Zero(), compressive = Vec3::Zero();
  double lengths = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const SplitForce f = split_force(field.elements()[h / 3], h % 3);
    add_m(sum, 1, f.tensile);
    add_m(sum, -1, f.compressive);
    tensile += f.tensile;
    compressive += f.compressive;
    lengths += f.tensile.norm();
  });
  add_m(sum, -1, tensile);
  add_m(sum, 1, compressive);
  return {0.5 * sum, 0.5 * (lengths + compressive.norm())};
}

}  // namespace craze
