// Attributes of a remeshed surface, read off the input at the nearest points.
#pragma once

#include <vector>

#include "craze/context.h"
#include "craze/mesh/closest_point.h"
#include "craze/mesh/edit_mesh.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The input with its patches (parted by seams) and a search tree labelled with them.
struct RemeshSource {
  const SurfaceMesh& surface;
  const std::vector<std::int32_t>& patch;  ///< #F
  const ClosestPoint& tree;
};

/// The mesh's faces as a surface, with every attribute of the source. Throws Cancelled.
SurfaceMesh transfer_attributes(const RemeshSource& source, const EditMesh& mesh,
                                const Context& context);

}  // namespace craze
