// Clear glass, and the cracks inside it.
#include <algorithm>
#include <cmath>

#include "craze/base/elementary.h"
#include "craze/render/material/noise.h"
#include "craze/render/rays/rays.h"
#include "craze/render/rays/tracer.h"

namespace craze::render {

namespace {

/// What a layer of the colour, `thickness` times as thick, lets through.
Rgb filtered(const Rgb& color, double thickness) {
  return color.unaryExpr(
      [&](float c) { return static_cast<float>(elementary::exp(thickness * elementary::log(c))); });
}

}  // namespace

float Tracer::fissure(const Surface& s, const Vec3f& inside, const LineSample& line,
                      Vec3f& facet) const {
  // A crack is a plane that goes down from its line. The ray, on its way into the glass, meets it
  // where it has come as far sideways as the line is away.
  const float distance = line.away.norm();
  if (distance == 0) return 0;
  const Vec3f across = line.away / distance;
  const float sideways = -inside.dot(across), down = -inside.dot(s.normal);
  if (sideways <= 1e-3f || down <= 0) return 0;
  const float depth = distance * down / sideways;
  const Vec3f at = s.place - line.away;
  const float reach = material_.fissure * (0.65f + 0.35f * value_noise(25 * at).value);
  if (depth >= reach) return 0;
  // Conchoidal: the plane bends and ripples on its way down.
  facet = (across + 0.35f * fractal_noise(20 * at + 40 * depth * s.normal, 2).gradient / 20 +
           0.25f * (value_noise(9 * at).value - 0.3f) * s.normal)
              .normalized();
  // Beyond 42 degrees the gap mirrors all light; less where the crack has closed again.
  const float mirror = 0.22f + 0.7f * smoothstep(0.85f, 0.55f, sideways);
  return mirror * (1 - smoothstep(0.35f * reach, reach, depth));
}

Rgb Tracer::through_glass(const Ray& first_ray, const Hit& first_hit, float footprint) const {
  Ray ray = first_ray;
  Hit hit = first_hit;
  Rgb seen = Rgb::Zero(), clear = Rgb::Ones();
  // Eight layers are more than the eye can tell apart.
  for (int layer = 0; layer < 8 && hit.face >= 0; ++layer) {
    const Surface s = surface_at(model_, material_, ray, hit, footprint);
    const float cosine = std::max(0.02f, -s.normal.dot(s.view));
    const float mirror = fresnel(cosine);
    const float depth = layer == 0 ? 1.0f : 0.6f;
    seen += depth * mirror * clear * studio_.reflection(reflected(s));
    clear *= (1 - mirror) * filtered(material_.color, 0.6f / std::sqrt(cosine));

    // Bend towards the inside of each layer.
    const Vec3f bent = (s.view - 0.3f * (1 - cosine) * s.normal).normalized();
    LineSample line = line_at(model_, hit, s.place, footprint);
    if (model_.is_wall[hit.face]) line.core = 0.3f;
    Vec3f facet;
    const float part = fissure(s, bent, line, facet);
    if (part > 0) {
      const Rgb glint = studio_.reflection(mirrored(bent, facet)) + 0.2f * material_.line;
      seen += 1.5f * depth * part * clear * glint;
      clear *= 1 - part;
    }
    // Where it comes to the surface, the crack scatters light.
    const float veil = std::clamp(material_.line_strength * line.core, 0.0f, 1.0f);
    const float facing = std::abs(s.geometric.dot(studio_.lamp_direction()));
    seen += depth * veil * clear * material_.line * (0.3f + 0.6f * facing);
    clear *= 1 - veil;

    ray = ray_from(s.position, -s.geometric, bent);
    hit = scene_.intersect(ray);
  }
  return seen +
         clear * (0.85f * backdrop(ray.direction) + 0.25f * studio_.reflection(ray.direction));
}

}  // namespace craze::render
