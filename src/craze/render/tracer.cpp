#include "craze/render/tracer.h"

#include <cmath>
#include <limits>

#include "craze/render/noise.h"

namespace craze::render {

namespace {

constexpr float ray_offset = 2e-5f;
/// Light from hidden directions: the object's own colour, lit about half as well.
constexpr float bounce = 0.22f;

/// Schlick's approximation for a clear coat of refractive index 1.5.
float fresnel(float cosine) {
  const float m = 1 - std::clamp(cosine, 0.0f, 1.0f), m2 = m * m;
  return 0.04f + 0.96f * m2 * m2 * m;
}

/// From −1 to 1, denser in the middle: a tent filter over two pixels, sampled.
float tent(float u) {
  return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u);
}

Vec3f mirrored(const Vec3f& d, const Vec3f& n) {
  return (d - 2 * d.dot(n) * n).normalized();
}

Ray ray_from(const Vec3f& position, const Vec3f& side, const Vec3f& direction) {
  return {position + ray_offset * side, direction, ray_offset, true};
}

}  // namespace

Tracer::Tracer(const TracedModel& model, const Material& material, const Camera& camera,
               const Studio& studio, bool ground, std::uint64_t seed)
    : model_(model),
      material_(material),
      camera_(camera),
      studio_(studio),
      scene_(model.positions, model.triangles),
      has_floor_(ground),
      seed_(seed) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Vec3& p : model.positions) {
    lowest = std::min(lowest, p.dot(camera.vertical));
    highest = std::max(highest, p.dot(camera.vertical));
  }
  // A flat sheet floats a little, so that its edge throws a shadow.
  floor_height_ = static_cast<float>(lowest - (highest - lowest < 0.02 ? 0.008 : 2e-4));
}

Tracer::Surface Tracer::surface_at(const Ray& ray, const Hit& hit, float footprint) const {
  const Triangle& t = model_.triangles[hit.face];
  const float w0 = 1 - hit.u - hit.v;
  const Vec3f a = model_.positions[t[0]].cast<float>(), b = model_.positions[t[1]].cast<float>(),
              c = model_.positions[t[2]].cast<float>();
  const Vec3f* n = &model_.normals[static_cast<std::size_t>(3) * hit.face];

  Surface s;
  s.lit = true;
  s.view = ray.direction.normalized();
  s.position = w0 * a + hit.u * b + hit.v * c;
  s.geometric = (b - a).cross(c - a).stableNormalized();
  if (s.geometric.dot(s.view) > 0) s.geometric = -s.geometric;
  s.normal = (w0 * n[0] + hit.u * n[1] + hit.v * n[2]).stableNormalized();
  if (s.normal.dot(s.geometric) < 0) s.normal = -s.normal;
  if (s.normal.isZero()) s.normal = s.geometric;

  const bool wall = model_.is_wall[hit.face] != 0;
  s.albedo = wall ? material_.wall : material_.color;
  s.coat = wall ? 0 : material_.coat;
  if (model_.lines && !wall) {
    const LineSample line = model_.lines->at(hit.face, s.position, footprint);
    const float core = line.core * material_.line_strength;
    s.albedo *= 1 - line.stain * material_.stain;
    s.albedo += core * (material_.line - s.albedo);
    s.coat *= 1 - 0.7f * core;
    s.normal = (s.normal + material_.groove * line.tilt).normalized();
  }
  // A smooth normal may turn away from the eye at the silhouette.
  const float away = s.normal.dot(s.view);
  if (away > -0.01f) s.normal = (s.normal - (away + 0.01f) * s.view).normalized();
  s.coat *= fresnel(-s.normal.dot(s.view));
  s.albedo *= 1 - s.coat;
  return s;
}

bool Tracer::floor_at(const Ray& ray, Vec3f& point) const {
  const float descent = ray.direction.dot(studio_.vertical());
  if (!has_floor_ || descent >= 0) return false;
  const float t = (floor_height_ - ray.origin.dot(studio_.vertical())) / descent;
  point = ray.origin + t * ray.direction;
  // Far away the floor is as bright as the backdrop, and it merges with it.
  return t > 0 && point.squaredNorm() < 9;
}

Rgb Tracer::backdrop(const Vec3f& direction) const {
  float x, y;
  studio_.project(direction, x, y);
  return studio_.backdrop(x, y);
}

float Tracer::floor_light(const Surface& s, bool lamp_hidden, bool sky_hidden) const {
  // Glass lets most of the light through.
  const float shade = material_.glass ? 0.35f : 0.9f;
  const float lamp = luminance(studio_.lamp_light()) * s.normal.dot(studio_.lamp_direction());
  const float sky = luminance(studio_.sky(studio_.vertical()));
  const float received = (lamp_hidden ? 0 : lamp) + (sky_hidden ? 0.12f * sky : sky);
  const float near = 1 - smoothstep(1.0f, 2.8f, s.position.norm());
  return 1 - shade * near * (1 - received / (lamp + sky));
}

Rgb Tracer::object_light(const Surface& s, const Ray& lamp, bool lamp_hidden, const Ray& sky,
                         bool sky_hidden) const {
  Rgb light = sky_hidden ? Rgb(bounce * s.albedo.max(0.05f).sqrt()) : studio_.sky(sky.direction);
  const float facing = s.normal.dot(lamp.direction);
  if (!lamp_hidden && facing > 0) light += facing * studio_.lamp_light();
  return light;
}

Rgb Tracer::sheen(const Surface& s, const Ray& lamp, bool lamp_hidden) const {
  if (lamp_hidden || material_.gloss == 0 || s.is_floor) return Rgb::Zero();
  const Vec3f half = (lamp.direction - s.view).normalized();
  return material_.gloss * std::pow(std::max(0.0f, half.dot(s.normal)), 18.0f) *
         studio_.lamp_light();
}

void Tracer::light(const Surfaces& surfaces, const SampleSet& lamp_samples,
                   const SampleSet& sky_samples, std::uint32_t first_sample, Pixel& sum) const {
  Lanes lamp, sky, mirror;
  bool any_mirror = false;
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    const Surface& s = surfaces[i];
    if (!s.lit) continue;
    const Vec3f to_lamp = cone_direction(studio_.lamp_direction(), studio_.lamp_size(),
                                         lamp_samples[first_sample + i]);
    const Vec3f to_sky = cosine_direction(s.normal, sky_samples[first_sample + i]);
    lamp[i] = ray_from(s.position, s.geometric, to_lamp);
    lamp[i].active = to_lamp.dot(s.normal) > 0;
    sky[i] = ray_from(s.position, s.geometric, to_sky);
    if (s.coat > 0) {
      any_mirror = true;
      mirror[i] = ray_from(s.position, s.geometric, mirrored(s.view, s.normal));
    }
  }
  RayScene::Flags lamp_hidden, sky_hidden, mirror_hidden{};
  scene_.occluded(lamp, lamp_hidden);
  scene_.occluded(sky, sky_hidden);
  if (any_mirror) scene_.occluded(mirror, mirror_hidden);

  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Surface& s = surfaces[i];
    if (!s.lit) continue;
    const Rgb received = s.is_floor
                             ? Rgb(Rgb::Constant(floor_light(s, lamp_hidden[i], sky_hidden[i])))
                             : object_light(s, lamp[i], lamp_hidden[i], sky[i], sky_hidden[i]);
    sum.albedo += s.albedo;
    sum.light += received;
    sum.diffuse += s.albedo * received;
    sum.direct += sheen(s, lamp[i], lamp_hidden[i]);
    if (s.coat > 0) {
      sum.direct += s.coat * (mirror_hidden[i] ? Rgb(0.4f * s.albedo)
                                               : studio_.reflection(mirror[i].direction));
    }
    sum.normal += s.normal;
    sum.position += s.position;
  }
}

Rgb Tracer::through_glass(const Ray& first_ray, const Hit& first_hit, float footprint) const {
  Ray ray = first_ray;
  Hit hit = first_hit;
  Rgb seen = Rgb::Zero(), clear = Rgb::Ones();
  // Eight layers are more than the eye can tell apart.
  for (int layer = 0; layer < 8 && hit.face >= 0; ++layer) {
    const Surface s = surface_at(ray, hit, footprint);
    const float cosine = std::max(0.02f, -s.normal.dot(s.view));
    const float mirror = fresnel(cosine);
    const float depth = layer == 0 ? 1.0f : 0.6f;
    seen += depth * mirror * clear * studio_.reflection(mirrored(s.view, s.normal));
    clear *= (1 - mirror) * material_.color.pow(0.6f / std::sqrt(cosine));

    LineSample line;
    if (model_.is_wall[hit.face]) {
      line.core = 0.3f;
    } else if (model_.lines) {
      line = model_.lines->at(hit.face, s.position, footprint);
    }
    // A crack is a bright plane inside the glass: it scatters light and hides what is behind.
    const float veil =
        std::clamp(material_.line_strength * line.core + material_.stain * line.stain, 0.0f, 1.0f);
    const float facing = std::abs(s.geometric.dot(studio_.lamp_direction()));
    seen += depth * veil * clear * material_.line * (0.55f + 0.75f * facing);
    clear *= 1 - veil;

    // Bend a little towards the inside of each layer.
    const Vec3f bent = (s.view - 0.12f * (1 - cosine) * s.normal).normalized();
    ray = ray_from(s.position, -s.geometric, bent);
    hit = scene_.intersect(ray);
  }
  return seen + clear * (0.8f * backdrop(ray.direction) + 0.2f * studio_.reflection(ray.direction));
}

Pixel Tracer::trace(int x, int y, int width, int height, int groups) const {
  const auto pixel = static_cast<std::uint32_t>(hash_bits(
      hash_bits(seed_) ^ (static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(width) + x)));
  const SampleSet lens(pixel, 1), lamp_samples(pixel, 2), sky_samples(pixel, 3);
  const Vec3f eye = camera_.eye.cast<float>();
  const float pixel_angle = static_cast<float>(2 * camera_.tan_y / height);

  Pixel sum;
  float mottle = -1;
  for (int group = 0; group < groups; ++group) {
    const auto first_sample = static_cast<std::uint32_t>(group * RayScene::lanes);
    Lanes rays;
    RayScene::Hits hits;
    for (std::uint32_t i = 0; i < rays.size(); ++i) {
      const Point2f u = lens[first_sample + i];
      const double px = 2 * (x + 0.5 + tent(u.x)) / width - 1;
      const double py = 1 - 2 * (y + 0.5 + tent(u.y)) / height;
      rays[i] = {eye, camera_.ray(px, py).cast<float>(), 0, true};
    }
    scene_.intersect(rays, hits);

    Surfaces surfaces;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      Surface& s = surfaces[i];
      if (hits[i].face < 0) {
        s.is_floor = s.lit = floor_at(rays[i], s.position);
        s.normal = s.geometric = studio_.vertical();
        s.albedo = backdrop(rays[i].direction);
        if (!s.lit) sum.direct += s.albedo;
        continue;
      }
      const float footprint = hits[i].distance * pixel_angle;
      if (material_.glass) {
        sum.direct += through_glass(rays[i], hits[i], footprint);
        continue;
      }
      s = surface_at(rays[i], hits[i], footprint);
      // The cloudiness is far coarser than a pixel: once is enough.
      if (mottle < 0) mottle = 1 + material_.mottle * fractal_noise(14 * s.position);
      s.albedo *= mottle;
    }
    light(surfaces, lamp_samples, sky_samples, first_sample, sum);
  }

  const float scale = 1.0f / static_cast<float>(groups * RayScene::lanes);
  sum.albedo *= scale;
  sum.light *= scale;
  sum.diffuse *= scale;
  sum.direct *= scale;
  sum.normal = sum.normal.stableNormalized();
  sum.position *= scale;
  return sum;
}

}  // namespace craze::render
