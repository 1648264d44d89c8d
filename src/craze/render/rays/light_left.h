// How much light comes along a ray, through whatever is see-through.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "craze/material/material.h"
#include "craze/render/material/surface.h"
#include "craze/render/rays/ray_scene.h"

namespace craze::render {

class LightLeft {
 public:
  using Lanes = std::array<float, RayScene::lanes>;

  /// Keeps references to all; `scene` is of the model's triangles. The looks of clear glass do not
  /// count.
  LightLeft(const TracedModel& model, const Material& material, const RayScene& scene);

  /// 0 … 1 for each active ray, 1 for others.
  void along(const RayScene::Rays& rays, Lanes& left) const;

 private:
  float through(Ray ray) const;

  const TracedModel& model_;
  const Material& material_;
  const RayScene& scene_;
  std::vector<std::int32_t> clear_faces_;            // that are see-through
  std::unique_ptr<const RayScene> solids_, clears_;  // the others and these; null: no such faces
};

}  // namespace craze::render
