// Triangles ready for ray tracing, sixteen rays at a time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "craze/render/material/color.h"
#include "craze/surface_mesh.h"
#include "craze/tensor.h"

namespace craze::render {

struct Ray {
  Vec3f origin, direction;
  float near = 0;
  bool active = false;  ///< inactive rays of a packet are skipped
};

struct Hit {
  std::int32_t face = -1;  ///< −1: nothing
  float distance = 0;      ///< in lengths of the direction
  float u = 0, v = 0;      ///< barycentric weights of corners 1 and 2
};

class RayScene {
 public:
  static constexpr int lanes = 16;
  using Rays = std::array<Ray, lanes>;
  using Hits = std::array<Hit, lanes>;
  using Flags = std::array<bool, lanes>;

  /// Coordinates are rounded to float: bring the model near the origin and to unit size first.
  RayScene(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The first hit of each active ray.
  void intersect(const Rays& rays, Hits& hits) const;
  Hit intersect(const Ray& ray) const;
  /// Whether each active ray hits anything; false for inactive ones.
  void occluded(const Rays& rays, Flags& hit) const;

 private:
  struct Handles;
  /// Where the ray meets the face that it is known to meet.
  Hit hit_on(const Ray& ray, std::int32_t face) const;

  std::unique_ptr<Handles> handles_;
};

}  // namespace craze::render
