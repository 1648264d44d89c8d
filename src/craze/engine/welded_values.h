// What vertices of an input have that welding makes one of.
#pragma once

#include <memory>

#include "craze/mesh/repair/traced_repair.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The input's triangles, colours and vertex attributes, where vertices that became one differ in
/// them, so that `traced` has lost some: flat colours, labels by face. Else null. Attributes that a
/// run replaces do not count.
std::shared_ptr<const SurfaceMesh> lost_by_welding(const SurfaceMesh& input,
                                                   const TracedSurface& traced);

}  // namespace craze
