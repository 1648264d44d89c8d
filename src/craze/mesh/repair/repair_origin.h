// Where in the input the faces of a repaired surface lie, in a tenth of SurfaceOrigin's bytes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/surface_origin.h"

namespace craze {

/// Corners of what repair makes are corners of input triangles and middles of their edges.
struct RepairOrigin {
  std::vector<std::int32_t> face;  ///< #F: the input's triangle
  /// 3 #F: corner i of face f, at 3f+i, lies halfway between these two corners of its triangle; the
  /// same twice: on it.
  std::vector<std::array<std::uint8_t, 2>> corners;

  /// As SurfaceOrigin::weights.
  Vec3 weights(std::size_t corner) const {
    const auto& [a, b] = corners[corner];
    return 0.5 * (Vec3::Unit(a) + Vec3::Unit(b));
  }
  SurfaceOrigin whole() const;
};

}  // namespace craze
