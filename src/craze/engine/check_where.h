// Names in [where] that the input does not have, found before any work.
#pragma once

#include <string>
#include <vector>

#include "craze/parameters.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A sentence for each pattern of where.materials and where.nodes that fits no name of the surface.
/// Throws Error(request), saying which names there are, where no pattern of a list fits any or
/// there is no such attribute, and where a picture is asked for of a surface without UVs.
std::vector<std::string> check_where(const SurfaceMesh& surface, const WhereParameters& where);

}  // namespace craze
