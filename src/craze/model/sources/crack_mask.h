// [where]: which faces crack, and how freely.
#pragma once

#include <vector>

#include "craze/grey_image.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/parameters.h"
#include "craze/surface_mesh.h"

namespace craze {

/// #F, from 0, where no crack may ever run, to 1, where nothing hinders; empty where `where` asks
/// for nothing. It is the product of 1 or 0 by material and by object, the attribute and the
/// picture, at the face's middle, or 1 minus that; and 0 where it is 0 at a corner. `mesh` is the
/// surface's own. A mesh that was `remeshed` has each face's numbers from its middle alone: there a
/// face that shares a corner with one that is 0, other than by its material, is 0 too. Throws
/// Error(request) for an attribute that is not there, not a scalar or not in 0 … 1, and for a
/// picture without UVs.
std::vector<double> crack_mask(const SurfaceMesh& surface, const TriangleMesh& mesh,
                               const WhereParameters& where, const GreyImage& picture,
                               bool remeshed);

}  // namespace craze
