// How a shown surface is shaded, by corners.
#pragma once

#include <vector>

#include "craze/engine.h"
#include "craze/products/opening/opened_surface.h"

namespace craze {

/// 3 #F of `shown`, which was made of `result`, unit: the mesh's own normals where it has some;
/// else those of the surface that cracked, smooth but for edges sharper than `crease` degrees, so
/// that neither cracks nor gaps leave a mark in the shading beside them, walls being flat; of a
/// curled surface its own, likewise.
std::vector<Vec3> shading_normals(const OpenedSurface& shown, const Result& result, double crease);

}  // namespace craze
