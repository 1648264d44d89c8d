// What the renderer needs to know of a run besides its mesh.
#pragma once

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/products/opening/opened_surface.h"
#include "craze/render/material/crack_lines.h"

namespace craze {

/// The cracks of the cut mesh as lines to draw on it, or as the worn edges of gaps.
render::CrackLines picture_lines(const OpenedSurface& shown, const Result& result, double reach,
                                 const Context& context);

}  // namespace craze
