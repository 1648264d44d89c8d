// The shaders of a material of a USDA file.
#pragma once

#include <string>

#include "craze/material_look.h"

namespace craze {

/// What is inside the Material prim at `path`: a UsdPreviewSurface of the look, and a UsdUVTexture
/// for each picture of it that has a file. What is transmitted is not opaque, in white instead of
/// in the base colour; where alpha counts and has a picture, the picture of what is transmitted
/// does not.
std::string usd_surface(const MaterialLook& look, const std::string& path);

/// The same, of the colours of the vertices.
std::string usd_surface_of_colors(const std::string& path);

}  // namespace craze
