// Points of the surface that the camera sees, each with what is known of the cracks there.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "craze/job/dataset/labels/crack_strips.h"
#include "craze/job/dataset/scene/scene.h"
#include "craze/render/image.h"

namespace craze {

struct LabelledPoint {
  Vec3 position;  ///< model units
  Vec3 normal;    ///< unit, toward the camera
  std::array<std::uint8_t, 3> color;
  bool labelled;          ///< in the mask, with the plan's label noise
  std::int32_t crack;     ///< of the scene's, where the point lies in one; −1: in none
  std::int32_t fragment;  ///< from 0
  double width;           ///< of that crack, length; 0: in none
  double distance;        ///< to the nearest centre line along the surface, length
};

struct CloudOptions {
  std::uint64_t count = 0;  ///< of rays: those that meet nothing give no point
  double least_width = 0;   ///< pixels; narrower cracks are not in the mask
  std::uint64_t seed = 1;
};

/// As a scanner at the camera has them: rays through places that are spread evenly over the
/// picture, however many of the first of them are taken [Roberts 2018, "The unreasonable
/// effectiveness of quasirandom sequences"]. `picture` gives the colours.
std::vector<LabelledPoint> point_cloud(const Scene& scene, const render::RayScene& rays,
                                       const LabelNoise& noise, const render::Image& picture,
                                       const CloudOptions& options);

/// Binary little-endian PLY: x y z nx ny nz red green blue mask crack fragment width distance.
std::string format_cloud(const Scene& scene, const std::vector<LabelledPoint>& points);

}  // namespace craze
