// The cracks of a network as maps draw them.
#pragma once

#include <vector>

#include "craze/model/crack_network.h"
#include "craze/products/maps/map_surface.h"

namespace craze {

/// One per edge. The network's edges keep one width each: at a node an edge takes the mean of its
/// own and that of the edge that goes on straightest, as it does of their times; a tip is shut.
std::vector<MapCrack> map_cracks(const CrackNetwork& network, const TriangleMesh& mesh);

}  // namespace craze
