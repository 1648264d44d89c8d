// The crack network as lines, for files and pictures.
#pragma once

#include "craze/mesh/line_set.h"
#include "craze/mesh/surface_mesh.h"
#include "craze/model/crack_network.h"

namespace craze {

/// Point attributes: junction (JunctionKind as a number), nx ny nz. Edge attributes: time, width,
/// event. UVs, two per edge, where the surface that the network's faces number has some.
LineSet network_lines(const CrackNetwork& network, const SurfaceMesh& surface);

}  // namespace craze
