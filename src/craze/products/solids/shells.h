// The parts of a mesh with its cracks shut.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

struct Shells {
  std::vector<std::int32_t> of_vertex;  ///< #V, numbers from 0; −1 for a vertex without faces
  std::vector<std::uint8_t> is_closed;  ///< by number: it has no border
};

Shells find_shells(const TriangleMesh& mesh, const CrackSites& sites);

}  // namespace craze
