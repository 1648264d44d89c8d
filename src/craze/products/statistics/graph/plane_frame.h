// Orthonormal frames of a plane given by its normal.
#pragma once

#include <Eigen/Geometry>

#include "craze/tensor.h"

namespace craze {

/// 3x2, orthonormal columns whose cross product is the unit normal. The first column is `axis`
/// projected into the plane; where that vanishes, the world axis least along the normal.
inline Mat32 plane_frame(const Vec3& normal, const Vec3& axis) {
  Vec3 first = axis - normal * normal.dot(axis);
  if (first.norm() < 1e-6 * axis.norm()) {
    int least = 0;
    normal.cwiseAbs().minCoeff(&least);
    first = Vec3::Unit(least) - normal * normal[least];
  }
  Mat32 frame;
  frame.col(0) = first.normalized();
  frame.col(1) = normal.cross(frame.col(0));
  return frame;
}

inline Mat32 plane_frame(const Vec3& normal) {
  return plane_frame(normal, Vec3::UnitX());
}

}  // namespace craze
