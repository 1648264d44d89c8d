// Chips as geometry.
#pragma once

#include <memory>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/products/chips/chips.h"

namespace craze {

struct ChippedMesh {
  /// Fine enough for the chips: vertices keep their numbers, each part of a face its source_face.
  /// Both sides of a crack are split alike.
  std::shared_ptr<const TriangleMesh> mesh;
  std::vector<double> depth;  ///< #V of it: how deep chips are there, length
};

/// A cut mesh with chips in the rims of its cracks. A chip goes over the faces around its middle
/// that no crack parts from it. Throws Cancelled.
ChippedMesh chipped_mesh(TriangleMesh mesh, const std::vector<MapCrack>& cracks, const Chips& chips,
                         const Context& context);

}  // namespace craze
