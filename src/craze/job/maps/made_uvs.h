// UVs for what has none, so that maps of it can be baked.
#pragma once

#include <string>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Gives `surface` an atlas in place of the UVs that it has, and returns what is to be told:
/// `reason` ("has no UVs") and into how many islands it was laid out. Throws Cancelled.
std::string make_uvs(SurfaceMesh& surface, const std::string& reason, const Context& context);

/// `result` with such UVs in place of none, and the cracks that it had; `told` is what there is to
/// tell. Throws Cancelled.
Result with_made_uvs(const Result& result, std::string& told, const Context& context);

}  // namespace craze
