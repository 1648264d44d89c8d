// A field that differs on the two sides of a crack, read off the simulation's mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/crack_network.h"
#include "craze/tensor.h"

namespace craze {

/// Side 0 is left of a network's edge from a to b, seen from outside; end 0 is a.
struct CrackSides {
  std::array<std::array<Vec3, 2>, 2> value;    ///< [side][end]
  std::array<std::int32_t, 2> face{{-1, -1}};  ///< of the mesh, at that side; −1: none was found
};

/// #network edges. `mesh` is the cut mesh that the network is of, `field` (#V) its values. A side
/// that was split less finely than the network is interpolated along its edge.
std::vector<CrackSides> crack_sides_of(const TriangleMesh& mesh, const std::vector<Vec3>& field,
                                       const CrackNetwork& network);

}  // namespace craze
