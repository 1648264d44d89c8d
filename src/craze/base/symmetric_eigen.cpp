#include "craze/base/symmetric_eigen.h"

#include <algorithm>
#include <cmath>

namespace craze {

namespace {

/// A unit vector that the rank-two tensor m maps to zero: the longest cross product of its rows.
Vec3 kernel(const Sym3& m) {
  const Vec3 r0(m.xx, m.xy, m.zx), r1(m.xy, m.yy, m.yz), r2(m.zx, m.yz, m.zz);
  const Vec3 c01 = r0.cross(r1), c12 = r1.cross(r2), c20 = r2.cross(r0);
  const double n01 = c01.squaredNorm(), n12 = c12.squaredNorm(), n20 = c20.squaredNorm();
  const Vec3& longest = n01 >= n12 && n01 >= n20 ? c01 : n12 >= n20 ? c12 : c20;
  return longest / longest.norm();
}

/// The largest pair of the tensor restricted to the plane across the unit vector n.
Eigenpair largest_across(const Sym3& a, const Vec3& n) {
  const Vec3 u = n.unitOrthogonal(), w = n.cross(u);
  const Vec3 au = a * u, aw = a * w;
  const double uu = u.dot(au), ww = w.dot(aw), uw = u.dot(aw);
  const double half = 0.5 * (uu - ww);
  const double radius = std::sqrt(half * half + uw * uw);
  if (radius == 0) return {uu, u};
  // (half, uw) points at twice the angle of the eigenvector.
  const Vec3 vector =
      half >= 0 ? Vec3((radius + half) * u + uw * w) : Vec3(uw * u + (radius - half) * w);
  return {0.5 * (uu + ww) + radius, vector / vector.norm()};
}

/// cos(arccos(c) / 3) for 0 ≤ c ≤ 1: the largest root y of 4 y³ − 3 y = c, where the slope is 6
/// to 9.
double cosine_of_third(double c) {
  double y = 0.8660 + c * (0.1667 - 0.0327 * c);  // to 2e-3; Newton's step squares it
  for (int step = 0; step < 3; ++step) y -= ((4 * y * y - 3) * y - c) / (12 * y * y - 3);
  return y;
}

}  // namespace

Eigenpair largest_eigenpair(const Sym3& tensor) {
  const double scale = std::max({std::abs(tensor.xx), std::abs(tensor.yy), std::abs(tensor.zz),
                                 std::abs(tensor.xy), std::abs(tensor.yz), std::abs(tensor.zx)});
  if (!(scale > 0)) return {0, Vec3::UnitX()};
  const Sym3 a = (1 / scale) * tensor;

  // λ = mean + 2 p y, 4 y³ − 3 y = det((a − mean I) / p) / 2, the cosine of thrice an angle.
  const double mean = (a.xx + a.yy + a.zz) / 3;
  Sym3 d = a;
  d.xx -= mean, d.yy -= mean, d.zz -= mean;
  const double p = std::sqrt((d.xx * d.xx + d.yy * d.yy + d.zz * d.zz) / 6 +
                             (d.xy * d.xy + d.yz * d.yz + d.zx * d.zx) / 3);
  if (p < 1e-15) return {scale * mean, Vec3::UnitX()};
  const double det = d.xx * (d.yy * d.zz - d.yz * d.yz) - d.xy * (d.xy * d.zz - d.yz * d.zx) +
                     d.zx * (d.xy * d.yz - d.yy * d.zx);
  const double cosine = std::clamp(0.5 * det / (p * p * p), -1.0, 1.0);
  // cosine ≥ 0: the largest root stands apart; otherwise the smallest does.
  const double apart = 2 * p * cosine_of_third(std::abs(cosine));
  const double root = cosine >= 0 ? apart : -apart;
  Sym3 shifted = d;
  shifted.xx -= root, shifted.yy -= root, shifted.zz -= root;
  const Vec3 axis = kernel(shifted);
  if (cosine >= 0) return {scale * (mean + root), axis};
  const Eigenpair pair = largest_across(a, axis);
  return {scale * pair.value, pair.vector};
}

}  // namespace craze
