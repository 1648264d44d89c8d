// What a sample's JSON says.
#pragma once

#include <string>
#include <vector>

#include "craze/job/dataset/labels/surface_maps.h"
#include "craze/job/dataset/sample.h"
#include "craze/job/dataset/scene/scene.h"

namespace craze {

/// What the numbers of the 16-bit pictures count.
namespace sample_scale {
inline constexpr double width = 256;      ///< per pixel
inline constexpr double distance = 1024;  ///< per pixel
inline constexpr double farthest = 63;    ///< pixels: all that is farther is as far
}  // namespace sample_scale

/// Depths as whole numbers: 0 nothing, 1 the nearest, 65,535 the farthest.
struct DepthRange {
  double nearest = 0, farthest = 0;  ///< model units

  double code(double depth) const;
};

DepthRange depth_range(const std::vector<float>& depths);

struct SampleFacts {
  const DatasetPlan& plan;
  std::uint64_t index;
  int attempt;
  bool clean;
  const PlanValues& values;
  const Scene& scene;
  const std::vector<SeenLine>& lines;
  DepthRange depths;
  const Sample& sample;  ///< with all files but this one
};

/// docs/datasets.md says what is in it. Cracks that the frame does not show are left out.
std::string sample_json(const SampleFacts& facts);

}  // namespace craze
