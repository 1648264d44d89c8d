// What each pixel shows of the surface, and how far it is from the cracks.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/job/dataset/scene/scene.h"
#include "craze/render/rays/ray_scene.h"

namespace craze {

/// At the pixels' centres; rows from the top, width · height numbers each.
struct SurfaceMaps {
  std::vector<float> depth;             ///< along the camera's axis, model units; 0: nothing there
  std::vector<Eigen::Vector3f> normal;  ///< x right, y up, z toward the camera; zero: nothing there
  std::vector<std::int32_t> fragment;   ///< −1: nothing there
};

SurfaceMaps surface_maps(const Scene& scene, const render::RayScene& rays);

/// A crack's centre line in the picture.
struct SeenLine {
  std::vector<Vec2> pixels;           ///< one per node of the whole crack
  std::vector<double> width;          ///< pixels, across the line
  std::vector<std::uint8_t> visible;  ///< in the frame and not hidden
  bool in_frame = false;              ///< any of it, hidden or not
};

/// One per crack of the scene.
std::vector<SeenLine> seen_lines(const Scene& scene, const render::RayScene& rays);

/// Whether the camera sees this point of the surface.
bool is_seen(const Projection& projection, const render::RayScene& rays, const Vec3& point);

/// Distance of each pixel's centre from the nearest centre line that is seen, pixels; at most
/// `limit`.
std::vector<float> distance_map(const std::vector<SeenLine>& lines, int width, int height,
                                double limit);

}  // namespace craze
