#include "craze/render/rays/tracer.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "craze/render/rays/rays.h"

namespace craze::render {

namespace {

/// Light from hidden directions: the object's own colour, lit about half as well.
constexpr float bounce = 0.22f;
/// Within this distance of the object's centre the floor may be in its shadow.
constexpr float floor_radius = 2;

bool any_active(const RayScene::Rays& rays) {
  return std::any_of(rays.begin(), rays.end(), [](const Ray& ray) { return ray.active; });
}

}  // namespace

Tracer::Tracer(const TracedModel& model, const Material& material, const Camera& camera,
               const Studio& studio, const std::vector<Vec3>& standing, int groups,
               std::uint64_t seed)
    : model_(model),
      material_(material),
      camera_(camera),
      studio_(studio),
      scene_(model.positions, model.triangles),
      light_left_(model, material, scene_),
      has_floor_(!standing.empty()),
      lens_radius_(static_cast<float>(camera.aperture / 2)),
      focus_(static_cast<float>(camera.focus)),
      groups_(groups),
      samples_(groups * RayScene::lanes, seed) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Vec3& p : standing) {
    lowest = std::min(lowest, p.dot(camera.vertical));
    highest = std::max(highest, p.dot(camera.vertical));
  }
  // A flat sheet floats a little, so that its edge throws a shadow.
  floor_height_ = static_cast<float>(lowest - (highest - lowest < 0.02 ? 0.008 : 2e-4));
  if (lens_radius_ == 0 || focus_ > 0) return;
  const Ray middle{camera.eye.cast<float>(), camera.forward.cast<float>(), 0, true};
  const Hit hit = scene_.intersect(middle);
  focus_ = hit.face >= 0 ? hit.distance : static_cast<float>(-camera.eye.dot(camera.forward));
}

Surface Tracer::floor_or_backdrop(const Ray& ray) const {
  Surface s;
  s.albedo = backdrop(ray.direction);
  const float descent = ray.direction.dot(studio_.vertical());
  if (!has_floor_ || descent >= 0) return s;
  const float t = (floor_height_ - ray.origin.dot(studio_.vertical())) / descent;
  s.position = s.raised = ray.origin + t * ray.direction;
  s.normal = s.geometric = studio_.vertical();
  // Beyond, the floor is as bright as the backdrop and merges with it.
  s.is_floor = s.lit = t > 0 && s.position.norm() < floor_radius;
  return s;
}

Rgb Tracer::backdrop(const Vec3f& direction) const {
  float x, y;
  studio_.project(direction, x, y);
  return studio_.backdrop(x, y);
}

float Tracer::floor_light(const Surface& s, float lamp_left, float sky_left) const {
  // Glass lets most of the light through.
  const float shade = material_.glass ? 0.35f : 0.9f;
  // A lamp below the floor does not light it.
  const float lamp =
      luminance(studio_.lamp_light()) * std::max(0.0f, s.normal.dot(studio_.lamp_direction()));
  const float sky = luminance(studio_.sky(studio_.vertical()));
  const float received = lamp_left * lamp + (0.12f * (1 - sky_left) + sky_left) * sky;
  const float near = 1 - smoothstep(0.5f * floor_radius, floor_radius, s.position.norm());
  return 1 - shade * near * (1 - received / std::max(lamp + sky, 1e-4f));
}

Rgb Tracer::object_light(const Surface& s, const Ray& to_lamp, float lamp, const Ray& to_sky,
                         float sky) const {
  Rgb light = (1 - sky) * bounce * s.albedo.max(0.05f).sqrt() + sky * studio_.sky(to_sky.direction);
  const float facing = s.normal.dot(to_lamp.direction);
  if (facing > 0) light += lamp * facing * studio_.lamp_light();
  return light;
}

Rgb Tracer::sheen(const Surface& s, const Ray& to_lamp, float lamp) const {
  if (lamp == 0 || material_.gloss == 0 || s.is_floor) return Rgb::Zero();
  const Vec3f half = (to_lamp.direction - s.view).normalized();
  const float c = std::max(0.0f, half.dot(s.normal)), c3 = c * c * c, c9 = c3 * c3 * c3;
  const float highlight = c9 * c9;
  return lamp * s.cover * material_.gloss * highlight * studio_.lamp_light();
}

void Tracer::light(const Surfaces& surfaces, const std::array<Rgb, RayScene::lanes>& through,
                   const PixelSamples& samples, int first, int count, float weight,
                   Pixel& sum) const {
  Lanes lamp, sky, mirror;
  bool any_mirror = false;
  for (int i = 0; i < count; ++i) {
    const Surface& s = surfaces[i];
    if (!s.lit) continue;
    const Vec3f to_lamp =
        cone_direction(studio_.lamp_direction(), studio_.lamp_size(), samples.lamp[first + i]);
    lamp[i] = ray_from(s.raised, s.geometric, to_lamp);
    lamp[i].active = to_lamp.dot(s.normal) > 0;
    sky[i] = ray_from(s.raised, s.geometric, cosine_direction(s.normal, samples.sky[first + i]));
    if (s.coat > 0) {
      any_mirror = true;
      mirror[i] = ray_from(s.raised, s.geometric, reflected(s));
    }
  }
  LightLeft::Lanes lamp_left, sky_left, mirror_left{};
  light_left_.along(lamp, lamp_left);
  light_left_.along(sky, sky_left);
  if (any_mirror) light_left_.along(mirror, mirror_left);

  for (int i = 0; i < count; ++i) {
    const Surface& s = surfaces[i];
    if (!s.lit) continue;
    const Rgb received = s.is_floor ? Rgb(Rgb::Constant(floor_light(s, lamp_left[i], sky_left[i])))
                                    : object_light(s, lamp[i], lamp_left[i], sky[i], sky_left[i]);
    const Rgb share = weight * through[i];
    const float part = share.mean() * (1 - s.clear.mean());  // of the pixel
    sum.albedo += share * s.albedo;
    sum.light += part * received;
    sum.diffuse += share * s.albedo * received;
    sum.direct += share * sheen(s, lamp[i], lamp_left[i]);
    if (s.coat > 0) {
      const float left = mirror_left[i];
      sum.direct += share * s.coat *
                    ((1 - left) * 0.4f * s.albedo + left * studio_.reflection(mirror[i].direction));
    }
    sum.normal += part * s.normal;
    sum.position += part * s.position;
    if (s.is_floor) sum.floor += part;
  }
}

Surface Tracer::surface_seen(const Ray& ray, const Hit& hit, float footprint,
                             std::optional<Grain>& grain) const {
  if (hit.face < 0) return floor_or_backdrop(ray);
  Surface s = surface_at(model_, material_, ray, hit, footprint);
  if (!grain) {
    grain = grain_at(material_, s.place, model_.pieces.empty() ? 0 : model_.pieces[hit.face],
                     model_.is_wall[hit.face] != 0, footprint);
  }
  s.albedo *= grain->tint;
  s.normal = (s.normal + grain->tilt - grain->tilt.dot(s.normal) * s.normal).normalized();
  return s;
}

Pixel Tracer::trace(int x, int y, int width, int height) const {
  const PixelSamples samples = samples_.of_pixel(static_cast<std::uint64_t>(y) * width + x);
  const Vec3f eye = camera_.eye.cast<float>();
  const Vec3f centre =
      camera_.ray(2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height).cast<float>();
  const Vec3f right = (2 * camera_.tan_x / width * camera_.right).cast<float>();
  const Vec3f down = (-2 * camera_.tan_y / height * camera_.up).cast<float>();
  const Vec3f lens_right = lens_radius_ * camera_.right.cast<float>();
  const Vec3f lens_up = lens_radius_ * camera_.up.cast<float>();

  Pixel sum;
  // The same for all samples of a layer: it is far coarser than a pixel.
  std::array<std::optional<Grain>, most_layers + 1> grains;
  for (int group = 0; group < groups_; ++group) {
    const int first = group * RayScene::lanes;
    Lanes rays;
    RayScene::Hits hits;
    for (int i = 0; i < RayScene::lanes; ++i) {
      const Point2f offset = samples.lens[first + i];
      rays[i] = {eye, centre + offset.x * right + offset.y * down, 0, true};
      if (lens_radius_ == 0) continue;
      // Rays through all of a thin lens meet where it is sharp.
      const Point2f through = samples.aperture[first + i];
      const Vec3f aside = through.x * lens_right + through.y * lens_up;
      rays[i].origin += aside;
      rays[i].direction -= aside / focus_;
    }
    scene_.intersect(rays, hits);

    const bool object =
        std::any_of(hits.begin(), hits.end(), [](const Hit& h) { return h.face >= 0; });
    // The empty floor is smooth: half of the samples will do.
    const int count = object ? RayScene::lanes : RayScene::lanes / 2;
    const float weight = static_cast<float>(RayScene::lanes) / static_cast<float>(count);
    for (int i = count; i < RayScene::lanes; ++i) rays[i].active = false;
    std::array<Rgb, RayScene::lanes> through;
    through.fill(Rgb::Ones());
    for (int layer = 0; any_active(rays); ++layer) {
      if (layer > 0) scene_.intersect(rays, hits);
      if (layer == most_layers) hits.fill({});
      Surfaces surfaces;
      for (int i = 0; i < count; ++i) {
        if (!rays[i].active) continue;
        const float footprint = hits[i].distance * down.norm();
        if (material_.glass && hits[i].face >= 0) {
          sum.direct += through_glass(rays[i], hits[i], footprint);
        } else {
          surfaces[i] = surface_seen(rays[i], hits[i], footprint, grains[layer]);
          if (hits[i].face < 0 && !surfaces[i].lit) {
            sum.direct += weight * through[i] * surfaces[i].albedo;
          }
        }
      }
      light(surfaces, through, samples, first, count, weight, sum);
      for (int i = 0; i < count; ++i) {
        if (!rays[i].active) continue;
        through[i] *= surfaces[i].clear;
        rays[i].near = behind(hits[i], rays[i]);
        rays[i].active = through[i].maxCoeff() > least_seen;
      }
    }
  }

  const float scale = 1.0f / static_cast<float>(groups_ * RayScene::lanes);
  sum.albedo *= scale;
  sum.light *= scale;
  sum.diffuse *= scale;
  sum.direct *= scale;
  sum.normal = sum.normal.stableNormalized();
  sum.position *= scale;
  sum.floor *= scale;
  return sum;
}

}  // namespace craze::render
