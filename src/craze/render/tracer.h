// Light at a pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/surface_mesh.h"
#include "craze/render/crack_lines.h"
#include "craze/render/film.h"
#include "craze/render/material.h"
#include "craze/render/ray_scene.h"
#include "craze/render/sampling.h"
#include "craze/render/studio.h"

namespace craze::render {

/// What is drawn, in render units: near the origin and of unit size.
struct TracedModel {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<Vec3f> normals;         ///< 3 #F
  std::vector<std::uint8_t> is_wall;  ///< #F
  const LinePainter* lines = nullptr;
};

class Tracer {
 public:
  /// Keeps references to the first four. With `ground`, a floor lies under the lowest vertex.
  Tracer(const TracedModel& model, const Material& material, const Camera& camera,
         const Studio& studio, bool ground, int groups, std::uint64_t seed);

  /// The pixel (x, y), counted from the top left, from `groups` times sixteen samples.
  Pixel trace(int x, int y, int width, int height) const;

 private:
  using Lanes = std::array<Ray, RayScene::lanes>;
  /// A lit point of the object or the floor.
  struct Surface {
    bool lit = false, is_floor = false;
    Vec3f position = Vec3f::Zero(), geometric = Vec3f::UnitZ(), normal = Vec3f::UnitZ();
    Vec3f view = Vec3f::UnitZ();  ///< unit, from the eye
    Rgb albedo = Rgb::Zero();
    float coat = 0;  ///< part of the light that the coat mirrors
  };
  /// Small irregularities of the surface, the same for all samples of a pixel.
  struct Grain {
    bool known = false;
    float tint = 1;
    Vec3f tilt = Vec3f::Zero();
  };
  using Surfaces = std::array<Surface, RayScene::lanes>;

  Surface surface_at(const Ray& ray, const Hit& hit, float footprint) const;
  Surface floor_or_backdrop(const Ray& ray) const;
  Grain grain_at(const Vec3f& position) const;
  Rgb backdrop(const Vec3f& direction) const;
  Rgb through_glass(const Ray& ray, const Hit& hit, float footprint) const;
  void light(const Surfaces& surfaces, const PixelSamples& samples, int first, int count,
             float weight, Pixel& sum) const;
  float floor_light(const Surface& s, bool lamp_hidden, bool sky_hidden) const;
  Rgb object_light(const Surface& s, const Ray& lamp, bool lamp_hidden, const Ray& sky,
                   bool sky_hidden) const;
  Rgb sheen(const Surface& s, const Ray& lamp, bool lamp_hidden) const;

  const TracedModel& model_;
  const Material& material_;
  const Camera& camera_;
  const Studio& studio_;
  RayScene scene_;
  bool has_floor_;
  float floor_height_ = 0;
  int groups_;
  SampleTable samples_;
};

}  // namespace craze::render
