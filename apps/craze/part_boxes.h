// The parts of a mesh and the boxes they fill.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze::app {

struct PartBox {
  Eigen::AlignedBox3d box;  ///< along the axes, model units
  std::int64_t triangles = 0;
};

/// One for each part (components.h), in the order of their lowest triangle.
std::vector<PartBox> part_boxes(const TriangleMesh& mesh);

}  // namespace craze::app
