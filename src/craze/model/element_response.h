// What an element answers to virtual displacements of its corners: the heart of every hot loop.
#pragma once

#include <cmath>

#include "craze/base/simd.h"
#include "craze/model/stress_field.h"

namespace craze {

/// The change of T and the forces that resist it at corners 1 and 2; corner 0 gets minus their sum.
/// Lanes 3 hold nothing of use.
struct ElementResponse {
  double t11, t22, t12;  ///< ΔT; apart, since packing them costs more than three additions
  Vec4d::Lanes f1;       ///< ΔT₁₁ e₁ + ΔT₁₂ e₂ = −Δf₁ of Eq. 1
  Vec4d::Lanes f2;

  /// A bound of the sizes of the three forces: of three that sum to zero none has more than two
  /// thirds of the sum of squares.
  double force_bound() const {
    const Vec4d::Lanes f0 = f1 + f2, squares = f1 * f1 + f2 * f2 + f0 * f0;
    return std::sqrt(2.0 / 3.0 * (squares[0] + squares[1] + squares[2]));
  }
  void add_stress_to(Element& element) const {
    element.t[0] += t11;
    element.t[1] += t22;
    element.t[2] += t12;
  }
};

/// [IO06 Eqs. 6, 7, then Eq. 1] d1, d2: displacements of corners 1 and 2 less that of corner 0.
/// With the edges as the material basis ∂ε_ab/∂p Δp = ½ (e_a·d_b + e_b·d_a) = q_ab, and ΔT = N q N.
inline ElementResponse element_response(const Element& element, const Vec4d::Lanes& d1,
                                        const Vec4d::Lanes& d2) {
  const Vec4d::Lanes e1 = element.e1.v, e2 = element.e2.v;
  const Vec4d::Lanes m11 = e1 * d1, m22 = e2 * d2, m12 = e1 * d2 + e2 * d1;
  const double q11 = m11[0] + m11[1] + m11[2];
  const double q22 = m22[0] + m22[1] + m22[2];
  const double q12 = 0.5 * (m12[0] + m12[1] + m12[2]);
  const double n11 = e1[3], n12 = e2[3], n22 = element.t.v[3];
  const double a11 = n11 * q11 + n12 * q12, a12 = n11 * q12 + n12 * q22;
  const double a21 = n12 * q11 + n22 * q12, a22 = n12 * q12 + n22 * q22;
  const double t11 = a11 * n11 + a12 * n12;
  const double t22 = a21 * n12 + a22 * n22;
  const double t12 = a11 * n12 + a12 * n22;
  return {t11, t22, t12, t11 * e1 + t12 * e2, t12 * e1 + t22 * e2};
}

}  // namespace craze
