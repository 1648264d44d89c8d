// Distances from points and segments to segments.
#pragma once

#include <algorithm>
#include <cmath>

#include "craze/tensor.h"

namespace craze {

/// Where on the segment ab the point nearest to p lies: 0 at a, 1 at b.
inline double nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double length = d.squaredNorm();
  return length > 0 ? std::clamp((p - a).dot(d) / length, 0.0, 1.0) : 0.0;
}

/// The point of the segment ab that is nearest to p.
inline Vec3 nearest_point(const Vec3& p, const Vec3& a, const Vec3& b) {
  return a + nearest_on_segment(p, a, b) * (b - a);
}

/// The square of point_segment_distance().
inline double squared_point_segment_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (nearest_point(p, a, b) - p).squaredNorm();
}

inline double point_segment_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  return std::sqrt(squared_point_segment_distance(p, a, b));
}

/// Distance between the segments ab and cd, which lie in one plane.
inline double coplanar_segment_distance(const Vec3& a, const Vec3& b, const Vec3& c,
                                        const Vec3& d) {
  const Vec3 e = d - c, s = b - a;
  const Vec3 ca = e.cross(a - c), cb = e.cross(b - c), ac = s.cross(c - a), ad = s.cross(d - a);
  if (ca.dot(cb) < 0 && ac.dot(ad) < 0) return 0;
  return std::sqrt(
      std::min({squared_point_segment_distance(a, c, d), squared_point_segment_distance(b, c, d),
                squared_point_segment_distance(c, a, b), squared_point_segment_distance(d, a, b)}));
}

}  // namespace craze
