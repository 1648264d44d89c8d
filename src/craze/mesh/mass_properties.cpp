#include "craze/mesh/mass_properties.h"

namespace craze {

MassProperties mass_properties(const std::vector<Vec3>& positions,
                               const std::vector<Triangle>& triangles) {
  MassProperties mass;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : positions) middle += p / static_cast<double>(positions.size());

  // Tetrahedra from the middle: with corners 0, a, b, c and sixfold volume w = det(a b c) the
  // integral of x is w (a + b + c) / 24, that of x xᵀ is w (a aᵀ + b bᵀ + c cᵀ + s sᵀ) / 120.
  double six_volumes = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const Triangle& t : triangles) {
    const Vec3 a = positions[t[0]] - middle, b = positions[t[1]] - middle,
               c = positions[t[2]] - middle;
    const double w = a.cross(b).dot(c);
    const Vec3 s = a + b + c;
    six_volumes += w;
    first += w * s;
    second += w * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  mass.volume = six_volumes / 6;
  mass.centre = middle;
  if (mass.volume == 0) return mass;
  const Vec3 offset = first / 24 / mass.volume;
  mass.centre += offset;
  const Mat3 square = offset * offset.transpose();  // alone: symmetric to the last bit
  const Mat3 moments = second / 120 - mass.volume * square;
  mass.inertia = moments.trace() * Mat3::Identity() - moments;
  return mass;
}

}  // namespace craze
