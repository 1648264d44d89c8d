// Where rays go from a surface.
#pragma once

#include "craze/render/material/surface.h"
#include "craze/render/rays/ray_scene.h"

namespace craze::render {

constexpr float ray_offset = 2e-5f;  ///< render units: far more than rounding

/// Surfaces that a ray may be followed through: more than a picture shows apart, and enough for the
/// leaves of a tree.
constexpr int most_layers = 64;
constexpr float least_seen = 1.0f / 512;  ///< of what lies behind

/// Where a ray goes on behind a hit: near enough not to miss what lies right below it.
inline float behind(const Hit& hit, const Ray& ray) {
  return hit.distance * (1 + 2e-6f) + 1e-6f / ray.direction.norm();
}

inline Vec3f mirrored(const Vec3f& d, const Vec3f& n) {
  return (d - 2 * d.dot(n) * n).normalized();
}

/// Off the smooth surface, but never into the triangle.
inline Vec3f reflected(const Surface& s) {
  const Vec3f d = mirrored(s.view, s.normal);
  const float rises = d.dot(s.geometric);
  constexpr float least = 0.02f;
  return rises >= least ? d : Vec3f((d + (least - rises) * s.geometric).normalized());
}

inline Ray ray_from(const Vec3f& position, const Vec3f& side, const Vec3f& direction) {
  return {position + ray_offset * side, direction, ray_offset, true};
}

}  // namespace craze::render
