#include "craze/mesh/corners_on_surface.h"

#include <cstddef>

namespace craze {

std::vector<Vec2> uvs_on_surface(const std::vector<Vec2>& corners, const SurfaceOrigin& origin) {
  std::vector<Vec2> result;
  result.reserve(origin.weights.size());
  for (std::size_t c = 0; c < origin.weights.size(); ++c) {
    const auto first = 3 * static_cast<std::size_t>(origin.face[c / 3]);
    result.push_back(interpolate_corners(origin.weights[c], [&](int i) -> Vec2 {
      return corners[first + static_cast<std::size_t>(i)];
    }));
  }
  return result;
}

}  // namespace craze
