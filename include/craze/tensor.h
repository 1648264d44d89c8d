// Small vectors and tensors used everywhere.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>

namespace craze {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;
using Mat32 = Eigen::Matrix<double, 3, 2>;

/// Symmetric 2x2 tensor in a triangle's tangent frame. For stress: force per length, tension
/// positive.
struct Sym2 {
  double xx = 0, yy = 0, xy = 0;

  static Sym2 isotropic(double c) { return {c, c, 0}; }

  Sym2& operator+=(const Sym2& o) {
    xx += o.xx;
    yy += o.yy;
    xy += o.xy;
    return *this;
  }
  friend Sym2 operator+(Sym2 a, const Sym2& b) { return a += b; }
  friend Sym2 operator*(double s, const Sym2& a) { return {s * a.xx, s * a.yy, s * a.xy}; }
  Vec2 operator*(const Vec2& v) const { return {xx * v.x() + xy * v.y(), xy * v.x() + yy * v.y()}; }

  double trace() const { return xx + yy; }
  /// Frobenius norm squared: the tensor's contraction with itself.
  double squared_norm() const { return xx * xx + yy * yy + 2 * xy * xy; }
};

/// Symmetric 3x3 tensor in world axes.
struct Sym3 {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;

  Sym3& operator+=(const Sym3& o) {
    xx += o.xx;
    yy += o.yy;
    zz += o.zz;
    xy += o.xy;
    yz += o.yz;
    zx += o.zx;
    return *this;
  }
  friend Sym3 operator*(double s, const Sym3& a) {
    return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
  }
  Vec3 operator*(const Vec3& v) const {
    return {xx * v.x() + xy * v.y() + zx * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
            zx * v.x() + yz * v.y() + zz * v.z()};
  }
  Mat3 matrix() const {
    Mat3 m;
    m << xx, xy, zx, xy, yy, yz, zx, yz, zz;
    return m;
  }
};

/// Adds s a aᵀ to m.
inline void add_outer(Sym3& m, double s, const Vec3& a) {
  m.xx += s * a.x() * a.x();
  m.yy += s * a.y() * a.y();
  m.zz += s * a.z() * a.z();
  m.xy += s * a.x() * a.y();
  m.yz += s * a.y() * a.z();
  m.zx += s * a.z() * a.x();
}

}  // namespace craze
