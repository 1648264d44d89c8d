// Orthonormal frames in the plane of a triangle.
#pragma once

#include "craze/mesh/triangle_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// 3x2, orthonormal columns spanning the triangle's plane; their cross product is the normal. The
/// first column runs along p0 → p1. The triangle must have area.
inline Mat32 tangent_frame(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  Mat32 frame;
  const Vec3 e1 = (p1 - p0).normalized();
  const Vec3 normal = (p1 - p0).cross(p2 - p0).normalized();
  frame.col(0) = e1;
  frame.col(1) = normal.cross(e1);
  return frame;
}

inline Mat32 tangent_frame(const TriangleMesh& mesh, std::int32_t f) {
  return tangent_frame(mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2));
}

/// Eᵀ S E: the part of a world tensor that lies in the frame E.
inline Sym2 to_frame(const Sym3& s, const Mat32& frame) {
  const Vec3 sx = s * frame.col(0), sy = s * frame.col(1);
  return {frame.col(0).dot(sx), frame.col(1).dot(sy), frame.col(0).dot(sy)};
}

/// E s Eᵀ: a tangent tensor in world axes; its normal components are zero.
inline Sym3 to_world(const Sym2& s, const Mat32& frame) {
  const Vec3 a = frame.col(0), b = frame.col(1);
  Sym3 m;
  add_outer(m, s.xx, a);
  add_outer(m, s.yy, b);
  m.xx += 2 * s.xy * a.x() * b.x();
  m.yy += 2 * s.xy * a.y() * b.y();
  m.zz += 2 * s.xy * a.z() * b.z();
  m.xy += s.xy * (a.x() * b.y() + a.y() * b.x());
  m.yz += s.xy * (a.y() * b.z() + a.z() * b.y());
  m.zx += s.xy * (a.z() * b.x() + a.x() * b.z());
  return m;
}

}  // namespace craze
