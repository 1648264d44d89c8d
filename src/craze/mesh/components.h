// The parts a mesh falls into.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

struct Components {
  std::int32_t count = 0;
  std::vector<std::int32_t> face;  ///< #F: the part of each face, 0 … count−1
};

/// Faces belong together where they share an edge that is not open; touching at a vertex does not
/// join. Parts are numbered in the order of their lowest face.
Components find_components(const TriangleMesh& mesh);

}  // namespace craze
