#include "craze/render/surface.h"

#include <algorithm>

#include "craze/render/noise.h"

namespace craze::render {

float fresnel(float cosine) {
  // Schlick's approximation for a refractive index of 1.5.
  const float m = 1 - std::clamp(cosine, 0.0f, 1.0f), m2 = m * m;
  return 0.04f + 0.96f * m2 * m2 * m;
}

LineSample line_at(const TracedModel& model, const Hit& hit, const Vec3f& position,
                   float footprint) {
  if (!model.lines || model.is_wall[hit.face]) return {};
  return model.lines->at(hit.face, position, footprint);
}

Surface surface_at(const TracedModel& model, const Material& material, const Ray& ray,
                   const Hit& hit, float footprint) {
  const Triangle& t = model.triangles[hit.face];
  const float w0 = 1 - hit.u - hit.v;
  const Vec3f a = model.positions[t[0]].cast<float>(), b = model.positions[t[1]].cast<float>(),
              c = model.positions[t[2]].cast<float>();
  const Vec3f* n = &model.normals[static_cast<std::size_t>(3) * hit.face];

  Surface s;
  s.lit = true;
  s.view = ray.direction.normalized();
  s.position = w0 * a + hit.u * b + hit.v * c;
  s.geometric = (b - a).cross(c - a).stableNormalized();
  if (s.geometric.dot(s.view) > 0) s.geometric = -s.geometric;
  s.normal = (w0 * n[0] + hit.u * n[1] + hit.v * n[2]).stableNormalized();
  if (s.normal.dot(s.geometric) < 0) s.normal = -s.normal;
  if (s.normal.isZero()) s.normal = s.geometric;

  const bool wall = model.is_wall[hit.face] != 0;
  s.albedo = wall ? material.wall : material.color;
  s.coat = wall ? 0 : material.coat;
  if (!wall) {
    const LineSample line = line_at(model, hit, s.position, footprint);
    const float core = line.core * material.line_strength;
    s.albedo *= 1 - line.stain * material.stain;
    s.albedo += core * (material.line - s.albedo);
    s.coat *= 1 - 0.7f * core;
    s.normal = (s.normal + material.groove * line.tilt).normalized();
  }
  // A smooth normal may turn away from the eye at the silhouette.
  const float away = s.normal.dot(s.view);
  if (away > -0.01f) s.normal = (s.normal - (away + 0.01f) * s.view).normalized();
  s.coat *= fresnel(-s.normal.dot(s.view));
  s.albedo *= 1 - s.coat;
  return s;
}

Grain grain_at(const Material& material, const Vec3f& position) {
  Grain grain;
  if (material.mottle > 0) grain.tint += material.mottle * fractal_noise(14 * position);
  if (material.bump > 0) {
    const Vec3f p = 34 * position;
    const float here = fractal_noise(p), step = 0.1f;
    for (int k = 0; k < 3; ++k) {
      grain.tilt[k] = here - fractal_noise(p + step * Vec3f::Unit(k));
    }
    grain.tilt *= material.bump / step;
  }
  return grain;
}

}  // namespace craze::render
