// Lines on or near a surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/surface_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// Polylines broken into edges, with everything attached.
struct LineSet {
  std::vector<Vec3> points;                        ///< #P
  std::vector<std::array<std::int32_t, 2>> edges;  ///< #E, point indices
  std::vector<Vec2> uvs;                           ///< 2 #E: one per edge end, or empty
  std::vector<Attribute> point_attributes;         ///< e.g. "junction"
  std::vector<Attribute> edge_attributes;          ///< e.g. "time", "width"
};

}  // namespace craze
