// What the renderer needs to know of a run besides its mesh.
#pragma once

#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/products/opening/opened_surface.h"
#include "craze/render/crack_lines.h"

namespace craze {

/// The corner normals to draw it with: those of the mesh where it has some; else the smooth ones of
/// the mesh that the simulation started with, so that neither cracks nor gaps leave a mark in
/// the shading beside them; walls are flat. Empty where the surface is curled and has to be shaded
/// as it is.
std::vector<Vec3> picture_normals(const OpenedSurface& shown, const Result& result,
                                  const PostParameters& post, double crease);

/// The cracks of the cut mesh as lines to draw on it, or as the worn edges of gaps.
render::CrackLines picture_lines(const OpenedSurface& shown, const Result& result, double reach,
                                 const Context& context);

}  // namespace craze
