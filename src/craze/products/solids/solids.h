// Fragments as closed solids.
#pragma once

#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"
#include "craze/products/opening/opening.h"

namespace craze {

struct SolidOptions {
  double thickness = 0;  ///< > 0, length, inwards
  double wedge = 0;      ///< 0 … 1: how much less cracks are open at the inner surface
  bool core = false;     ///< what is left inside a closed shell is a solid too
};

/// Closes each fragment of an opened mesh without walls: walls along cracks and along the border of
/// the input, and an inner surface, `thickness` below the outer one and moved with it, but for the
/// part `wedge` of the way; where cracks are shut neighbours share their walls. `outwards` (#V):
/// inner_directions.h. Appends to `opened` and fills opened.solid; gives what could not be done as
/// asked, a sentence each. Each solid is closed by index and oriented outwards; none passes through
/// another but where the opened mesh itself does, or the warnings say so. Throws Cancelled.
std::vector<std::string> make_solid(const TriangleMesh& mesh, const CrackSites& sites,
                                    std::vector<Vec3> outwards, const SolidOptions& options,
                                    OpenedMesh& opened, const Context& context);

}  // namespace craze
