// Light at a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "craze/material/material.h"
#include "craze/render/film.h"
#include "craze/render/light/studio.h"
#include "craze/render/material/surface.h"
#include "craze/render/rays/light_left.h"
#include "craze/render/rays/ray_scene.h"
#include "craze/render/rays/sampling.h"

namespace craze::render {

class Tracer {
 public:
  /// Keeps references to the first four. A floor lies under the lowest of `standing`; empty: none.
  Tracer(const TracedModel& model, const Material& material, const Camera& camera,
         const Studio& studio, const std::vector<Vec3>& standing, int groups, std::uint64_t seed);

  /// The pixel (x, y), counted from the top left, from `groups` times sixteen samples.
  Pixel trace(int x, int y, int width, int height) const;

 private:
  using Lanes = std::array<Ray, RayScene::lanes>;
  using Surfaces = std::array<Surface, RayScene::lanes>;

  /// What a ray meets; `grain` is of its layer, made where there is none yet.
  Surface surface_seen(const Ray& ray, const Hit& hit, float footprint,
                       std::optional<Grain>& grain) const;
  Surface floor_or_backdrop(const Ray& ray) const;
  Rgb backdrop(const Vec3f& direction) const;
  /// How much of a ray that goes on `inside` the glass a crack plane below the surface mirrors, and
  /// the plane's normal there.
  float fissure(const Surface& s, const Vec3f& inside, const LineSample& line, Vec3f& facet) const;
  Rgb through_glass(const Ray& ray, const Hit& hit, float footprint) const;
  /// `through`: how much of each surface is seen.
  void light(const Surfaces& surfaces, const std::array<Rgb, RayScene::lanes>& through,
             const PixelSamples& samples, int first, int count, float weight, Pixel& sum) const;
  /// `lamp` and `sky` below: how much of their light gets through to the surface, 0 … 1.
  float floor_light(const Surface& s, float lamp, float sky) const;
  Rgb object_light(const Surface& s, const Ray& to_lamp, float lamp, const Ray& to_sky,
                   float sky) const;
  Rgb sheen(const Surface& s, const Ray& to_lamp, float lamp) const;

  const TracedModel& model_;
  const Material& material_;
  const Camera& camera_;
  const Studio& studio_;
  RayScene scene_;
  LightLeft light_left_;
  bool has_floor_;
  float floor_height_ = 0;
  float lens_radius_, focus_;  // of a thin lens; the distance of what is sharp, along the axis
  int groups_;
  SampleTable samples_;
};

}  // namespace craze::render
