// What each pixel shows of the cracks.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/job/dataset/labels/crack_strips.h"
#include "craze/job/dataset/scene/scene.h"
#include "craze/render/rays/ray_scene.h"

namespace craze {

/// Rows from the top, width · height numbers each.
struct CrackMaps {
  std::vector<float> coverage;      ///< 0 … 1, the part of the pixel's area that cracks cover
  std::vector<float> label;         ///< the same with the plan's label noise
  std::vector<float> width;         ///< pixels, of the crack that is nearest; 0 where none covers
  std::vector<std::int32_t> crack;  ///< that crack, index into the scene's; −1 where none covers
};

/// The share of a pixel's area where a point of the surface lies in a crack (scene.h), by the exact
/// area of the piecewise linear function through 8 × 8 cells of distances; hidden cracks do not
/// count. `rays` is the scene's mesh in render units.
CrackMaps crack_maps(const Scene& scene, const render::RayScene& rays, const LabelNoise& noise,
                     const Context& context);

}  // namespace craze
